package org.selectiverenderer.browser.nodes.shader;

import java.util.Map;
import org.selectiverenderer.browser.scene.NodeConstructor;

/** The constructors of the shader nodes that receive events, by node type name. */
public final class ShaderNodeConstructors {
  private ShaderNodeConstructors() {}

  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "ComposedShader", ShaderNode::new,
          "PackagedShader", ShaderNode::new,
          "ProgramShader", ShaderNode::new,
          "ShaderProgram", ShaderNode::new);
}
