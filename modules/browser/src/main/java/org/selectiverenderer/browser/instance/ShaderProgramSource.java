package org.selectiverenderer.browser.instance;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * The source of a GLSL shader program that the scene's author wrote for a surface: a shader node of
 * an Appearance's {@code shaders} (X3D 4.0, 12.4.2 and clause 31).
 *
 * @param parts the sources of its shader stages
 * @param fields the fields that the author declared, which become uniforms and textures of the
 *     program
 * @param textures the textures of the Appearance, in their order
 */
public record ShaderProgramSource(
    ShaderNode node, List<Part> parts, List<ProgramField> fields, List<TextureUnit> textures) {

  /** A shader stage: vertex, geometry or fragment. */
  public enum Stage {
    VERTEX,
    GEOMETRY,
    FRAGMENT;

    /**
     * Returns the stage of a part's {@code type}; GEOMETRY is an extension of X_ITE and Castle Game
     * Engine.
     */
    public static Optional<Stage> named(String type) {
      return Arrays.stream(values()).filter(stage -> stage.name().equals(type)).findFirst();
    }
  }

  /** The source of a stage; a stage may have several. */
  public record Part(Stage stage, ShaderSource text) {}

  /**
   * A field that the author declared. Its value is read whenever the shape is drawn.
   *
   * @param holder the node that has the field
   * @param textures the textures in a field of nodes, in their order, without those that have no
   *     image
   */
  public record ProgramField(
      Node holder, int index, String name, FieldType type, List<TextureSource> textures) {
    /** Returns the present value, as {@link FieldType} represents it. */
    public Object value() {
      Object value = holder.value(index);
      return value == null ? List.of() : value;
    }
  }
}
