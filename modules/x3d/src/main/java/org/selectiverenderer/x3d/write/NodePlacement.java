package org.selectiverenderer.x3d.write;

import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.write.SceneItem.Place;

/** Determines the field of a node that contains a child, as the reader does. */
final class NodePlacement {
  private NodePlacement() {}

  /**
   * Returns the place of a child in its parent; null if there is none.
   *
   * @param type the type of the child, or of the first node of an instance; null if the prototype
   *     is in another file
   * @param taken the fields of the parent that have the one node that they can have
   */
  static @Nullable Place of(
      DocumentElement child,
      NodeType parent,
      @Nullable NodeType type,
      boolean instance,
      Set<String> taken) {
    String wanted = child.text("containerField").orElse(null);
    if (type == null) {
      return unresolved(parent, wanted == null ? "children" : wanted);
    }
    FieldDefinition field =
        ContainerFieldRules.wanted(parent, type, wanted)
            .or(() -> usual(parent, type))
            .or(() -> fitting(parent, type, taken))
            .orElse(null);
    if (field == null) {
      return null;
    }
    // readers differ in the default containerField of an instance, except for children
    boolean usual =
        instance
            ? field.name().equals("children")
            : ContainerFieldRules.isAlwaysDefault(type, field.name());
    return new Place(field.name(), field.type().multiple(), usual);
  }

  /** Returns the place of an instance of a prototype whose file is not read. */
  private static @Nullable Place unresolved(NodeType parent, String name) {
    String now = ContainerFieldRules.renamed(parent, name).orElse(name);
    FieldDefinition field = parent.field(now).orElse(null);
    if (field == null) {
      return name.equals("children") ? new Place(name, true, true) : null;
    }
    return field.type().isNode()
        ? new Place(now, field.type().multiple(), now.equals("children"))
        : null;
  }

  private static Optional<FieldDefinition> usual(NodeType parent, NodeType type) {
    return parent
        .field(type.containerField())
        .filter(field -> ContainerFieldRules.accepts(field, type));
  }

  private static Optional<FieldDefinition> fitting(
      NodeType parent, NodeType type, Set<String> taken) {
    Optional<FieldDefinition> free =
        ContainerFieldRules.fitting(parent, type).stream()
            .filter(field -> field.type().multiple() || !taken.contains(field.name()))
            .findFirst();
    return free.or(() -> ContainerFieldRules.fitting(parent, type).stream().findFirst());
  }
}
