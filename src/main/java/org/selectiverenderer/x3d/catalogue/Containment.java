package org.selectiverenderer.x3d.catalogue;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Which field of a node takes a child (ISO/IEC 19776-1, 4.3.6: containerField). */
public final class Containment {
  private Containment() {}

  /**
   * The field that a child asks for, if it is there and takes such a node.
   *
   * @param containerField as the file gives it, or null for the one that nodes of its type go into
   */
  public static Optional<FieldDefinition> wanted(
      NodeType parent, NodeType child, @Nullable String containerField) {
    String name = containerField != null ? containerField : usual(parent, child);
    FieldDefinition field = parent.field(name).orElse(null);
    if (field == null) {
      field = renamed(parent, name).flatMap(parent::field).orElse(null);
    }
    return Optional.ofNullable(field).filter(found -> accepts(found, child));
  }

  /** The name of the field that a child goes into when the file does not say. */
  public static String usual(NodeType parent, NodeType child) {
    // The catalogue's default is that of metadata in a MetadataSet.
    return child.is("X3DMetadataObject") && parent.field("value").isEmpty()
        ? "metadata"
        : child.containerField();
  }

  /**
   * What X3D 4.0 calls a field of such a node that earlier editions called otherwise: the children
   * of a Switch or LOD in VRML97, the sides of a ComposedCubeMapTexture in X3D 3.
   */
  public static Optional<String> renamed(NodeType parent, String name) {
    return switch (parent.name()) {
      case "Switch" -> Optional.of("children").filter(now -> name.equals("choice"));
      case "LOD" -> Optional.of("children").filter(now -> name.equals("level"));
      case "LoadSensor" -> Optional.of("children").filter(now -> name.equals("watchList"));
      case "ParticleSystem" ->
          Optional.of(name.replace("Ramp", ""))
              .filter(now -> name.equals("colorRamp") || name.equals("texCoordRamp"));
      case "ComposedCubeMapTexture" ->
          Optional.of(name + "Texture").filter(now -> parent.field(now).isPresent());
      default -> Optional.empty();
    };
  }

  /** All fields of a node that take such a child, in the order of the catalogue. */
  public static List<FieldDefinition> fitting(NodeType parent, NodeType child) {
    return parent.fields().stream().filter(field -> accepts(field, child)).toList();
  }

  /** Whether a file may put a node of that type into the field. */
  public static boolean accepts(FieldDefinition field, NodeType child) {
    if (!field.type().isNode() || !field.access().initialisable()) {
      return false;
    }
    for (String type : field.nodeTypes()) {
      if (child.is(type)) {
        return true;
      }
    }
    return false;
  }
}
