package org.selectiverenderer.runtime.nodes.shader;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The constructors of the shader nodes that receive events, by node type name. */
public final class Shaders {
  private Shaders() {}

  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "ComposedShader", ShaderNode::new,
          "PackagedShader", ShaderNode::new,
          "ProgramShader", ShaderNode::new,
          "ShaderProgram", ShaderNode::new);
}
