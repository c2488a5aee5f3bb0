package org.selectiverenderer.runtime.instance;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.runtime.nodes.shader.ShaderNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.shader.ShaderText;

/**
 * A program in GLSL that an author wrote for a surface: a shader node of an Appearance's {@code
 * shaders} (X3D 4.0, 12.4.2 and 31).
 *
 * @param parts its stages
 * @param fields what its author declared, which become numbers and textures of the program
 * @param textures of the Appearance, in their order
 */
public record SurfaceProgram(
    ShaderNode node, List<Part> parts, List<ProgramField> fields, List<TextureUnit> textures) {

  /** Which vertices, primitives or pixels a text is about. */
  public enum Stage {
    VERTEX,
    GEOMETRY,
    FRAGMENT;

    /** The stage that a part's {@code type} means; X_ITE and Castle also have GEOMETRY. */
    public static Optional<Stage> named(String type) {
      return Arrays.stream(values()).filter(stage -> stage.name().equals(type)).findFirst();
    }
  }

  /** The text of a stage; more than one may be of the same. */
  public record Part(Stage stage, ShaderText text) {}

  /**
   * A field that the author declared. Its value is asked for when the shape is drawn.
   *
   * @param holder the node that has it
   * @param textures those in a field of nodes, in their order; of one without an image there is
   *     none
   */
  public record ProgramField(
      Node holder, int index, String name, FieldType type, List<TextureSource> textures) {
    /** The value now, as {@link FieldType} represents it. */
    public Object value() {
      Object value = holder.value(index);
      return value == null ? List.of() : value;
    }
  }
}
