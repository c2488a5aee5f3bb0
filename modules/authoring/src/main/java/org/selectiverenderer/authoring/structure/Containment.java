package org.selectiverenderer.authoring.structure;

import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.StatementNames;

/**
 * The standard's containment: which elements a scene's element may contain, and in which field.
 *
 * <p>Fields are those of the catalogue (ISO/IEC 19776-1, 4.3.6). An instance of a prototype may
 * stand where the first node of its body may (X3D 4.0, 4.4.4.3); one of an unknown prototype stands
 * in its {@code containerField}, else among {@code children}.
 */
final class Containment {
  static final String CHILDREN = "children";
  private static final String INSTANCE = "ProtoInstance";
  private static final int NESTED = 8;

  /** Statements that stand beside the nodes of a scene or a prototype's body. */
  private static final Set<String> BESIDE_NODES =
      Set.of("ROUTE", "IMPORT", "EXPORT", "ProtoDeclare", "ExternProtoDeclare");

  private final NodeCatalogue catalogue;

  Containment(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  /**
   * A field that takes a child.
   *
   * @param field the field's name; empty for what is no node, such as a ROUTE
   * @param multiple whether the field takes several nodes
   */
  record Place(Optional<String> field, boolean multiple) {
    static final Place STATEMENT = new Place(Optional.empty(), true);

    static Place of(FieldDefinition field) {
      return new Place(Optional.of(field.name()), field.type().multiple());
    }
  }

  /** Returns whether an element may contain another, if the fields for it are free. */
  boolean accepts(DocumentElement parent, DocumentElement child) {
    return place(parent, child, Set.of()).isPresent();
  }

  /**
   * Returns the place of a child in an element.
   *
   * @param taken names of the fields that have their only node already
   */
  Optional<Place> place(DocumentElement parent, DocumentElement child, Set<String> taken) {
    String name = child.name();
    boolean node = name.equals(INSTANCE) || catalogue.find(name).isPresent();
    if (parent.use().isPresent() || !node && !BESIDE_NODES.contains(name)) {
      return Optional.empty();
    }
    return switch (parent.name()) {
      case "Scene" ->
          node && !type(child).map(Containment::root).orElse(true)
              ? Optional.empty()
              : Optional.of(node ? new Place(Optional.of(CHILDREN), true) : Place.STATEMENT);
      case "ProtoBody" -> Optional.of(Place.STATEMENT);
      case "field", "fieldValue" -> node ? valueOf(parent, taken) : Optional.empty();
      default ->
          catalogue
              .find(parent.name())
              .flatMap(type -> node ? inNode(type, child, taken) : statementIn(type));
    };
  }

  private static boolean root(NodeType type) {
    return type.is("X3DChildNode")
        || type.is("X3DMetadataObject")
        || type.name().equals("LayerSet");
  }

  private static Optional<Place> statementIn(NodeType parent) {
    return parent.field(CHILDREN).map(field -> Place.STATEMENT);
  }

  private static Optional<Place> valueOf(DocumentElement field, Set<String> taken) {
    String type = field.text("type").orElse("MFNode");
    boolean free = type.equals("MFNode") || type.equals("SFNode") && !taken.contains("value");
    return free
        ? Optional.of(new Place(Optional.of("value"), type.equals("MFNode")))
        : Optional.empty();
  }

  private Optional<Place> inNode(NodeType parent, DocumentElement child, Set<String> taken) {
    String written = child.text("containerField").orElse(null);
    Optional<NodeType> type = type(child);
    if (type.isEmpty()) {
      return parent
          .field(written == null ? CHILDREN : written)
          .filter(field -> field.type().isNode() && !taken.contains(field.name()))
          .map(Place::of);
    }
    return ContainerFieldRules.wanted(parent, type.get(), written)
        .filter(field -> !taken.contains(field.name()))
        .or(() -> fitting(parent, type.get(), taken))
        .map(Place::of);
  }

  private static Optional<FieldDefinition> fitting(
      NodeType parent, NodeType child, Set<String> taken) {
    return ContainerFieldRules.wanted(parent, child, null)
        .filter(field -> !taken.contains(field.name()))
        .or(
            () ->
                ContainerFieldRules.fitting(parent, child).stream()
                    .filter(field -> !taken.contains(field.name()))
                    .findFirst());
  }

  /** Returns the type of a node; empty if it is unknown. */
  Optional<NodeType> type(DocumentElement node) {
    return type(node, NESTED);
  }

  private Optional<NodeType> type(DocumentElement node, int depth) {
    return node.name().equals(INSTANCE) && depth > 0
        ? node.text("name")
            .flatMap(name -> body(node, name))
            .flatMap(first -> type(first, depth - 1))
        : catalogue.find(node.name());
  }

  /** Returns the first node of the body of the prototype that an instance sees. */
  private Optional<DocumentElement> body(DocumentElement instance, String name) {
    for (DocumentElement at = instance; at.parent().isPresent(); at = at.parent().get()) {
      for (DocumentElement declared : at.parent().get().children()) {
        if (declared.name().equals("ProtoDeclare")
            && declared.text("name").filter(name::equals).isPresent()) {
          return declared.children().stream()
              .filter(part -> part.name().equals("ProtoBody"))
              .flatMap(part -> part.children().stream())
              .filter(part -> part.name().equals(INSTANCE) || !StatementNames.is(part.name()))
              .findFirst();
        }
      }
    }
    return Optional.empty();
  }
}
