package org.selectiverenderer.x3d.catalogue;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Determines the field of a parent that takes a child node (containerField, 19776-1, 4.3.6). */
public final class ContainerFieldRules {
  private ContainerFieldRules() {}

  /**
   * Returns the field that a child's containerField names, if it exists and accepts the child.
   *
   * @param containerField the value in the file, or null for the default of the child's type
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

  /**
   * Returns whether a field is the default containerField of a type in every edition of the
   * standard. That of metadata is {@code metadata} in X3D 3 and {@code value} in some readers of
   * X3D 4.0, whose 4.2 gives it for metadata in a MetadataSet.
   */
  public static boolean isAlwaysDefault(NodeType child, String field) {
    return !child.is("X3DMetadataObject") && field.equals(child.containerField());
  }

  /** Returns the default containerField of a child in a parent. */
  public static String usual(NodeType parent, NodeType child) {
    // the catalogue's default applies to metadata in a MetadataSet
    return child.is("X3DMetadataObject") && parent.field("value").isEmpty()
        ? "metadata"
        : child.containerField();
  }

  /**
   * Returns the X3D 4.0 name of a node field that earlier editions named differently: the children
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

  /** Returns all fields of a parent that accept a child, in the order of the catalogue. */
  public static List<FieldDefinition> fitting(NodeType parent, NodeType child) {
    return parent.fields().stream().filter(field -> accepts(field, child)).toList();
  }

  /** Returns whether a file may put a node of a type into a field. */
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
