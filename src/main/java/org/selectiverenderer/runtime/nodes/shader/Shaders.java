package org.selectiverenderer.runtime.nodes.shader;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The nodes of the Shaders component that receive events. */
public final class Shaders {
  private Shaders() {}

  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "ComposedShader", ShaderNode::new,
          "PackagedShader", ShaderNode::new,
          "ProgramShader", ShaderNode::new,
          "ShaderProgram", ShaderNode::new);
}
