package org.selectiverenderer.authoring.editing;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.FieldValueConstraints;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;

/**
 * Lists the fields that the prototype of an instance declares, in its order, and then those that
 * the instance gives without a declaration. Bounds, words and missing defaults are those of the
 * node field to which IS connects a field in the body.
 */
final class InterfaceFieldList {
  /** The largest number of fields; an interface of a stranger may declare any number. */
  private static final int MANY = 500;

  /** The largest body in which connections are searched after every change. */
  private static final int SEARCHED = 200_000;

  /** The largest default that is shown. */
  private static final int LONG = 200;

  /** Why a value that is nodes is not written. */
  static final String HOLDS_NODES = "It holds nodes, which are changed in the tree and the source.";

  private final SceneDocument document;
  private final NodeCatalogue catalogue;
  private final DocumentElement instance;
  private final String prototype;
  private final Optional<DocumentElement> declaration;
  private final Map<String, DocumentElement> values = new LinkedHashMap<>();
  private final Map<String, Connection> connections = new HashMap<>();
  private final Map<String, NodeField> fields = new LinkedHashMap<>();

  /** Why declared fields that the instance gives have no value. */
  private final Map<String, String> refused = new HashMap<>();

  /** A node field that IS connects with a field of the interface. */
  private record Connection(DocumentElement node, FieldDefinition field) {}

  private InterfaceFieldList(
      SceneDocument document, NodeCatalogue catalogue, DocumentElement instance) {
    this.document = document;
    this.catalogue = catalogue;
    this.instance = instance;
    this.prototype = instance.text("name").orElse("").strip();
    this.declaration = declaration(document, prototype, instance);
  }

  /** Returns whether an element is an instance with values of its own. */
  static boolean applies(DocumentElement element) {
    return element.name().equals("ProtoInstance") && element.use().isEmpty();
  }

  /** Returns the declaration that a prototype's name means at an instance. */
  static Optional<DocumentElement> declaration(
      SceneDocument document, String name, DocumentElement instance) {
    return document.tree().flatMap(tree -> tree.prototype(name, instance));
  }

  /** Returns the elements that give a field of an instance; the last one counts. */
  static List<DocumentElement> values(DocumentElement instance, String name) {
    return instance.children().stream()
        .filter(child -> child.name().equals("fieldValue"))
        .filter(child -> child.text("name").filter(name::equals).isPresent())
        .toList();
  }

  /** Returns the fields of an instance. */
  static List<NodeField> of(
      SceneDocument document, NodeCatalogue catalogue, DocumentElement instance) {
    return new InterfaceFieldList(document, catalogue, instance).list();
  }

  private List<NodeField> list() {
    for (DocumentElement child : instance.children()) {
      if (child.name().equals("fieldValue") && values.size() < MANY) {
        child.text("name").ifPresent(name -> values.put(name, child));
      }
    }
    declaration
        .filter(of -> of.end() - of.start() < SEARCHED)
        .ifPresent(of -> of.children().stream().filter(this::body).forEach(this::connect));
    declaration.ifPresent(
        of ->
            Stream.concat(
                    of.children().stream(),
                    of.children().stream()
                        .filter(child -> child.name().equals("ProtoInterface"))
                        .flatMap(child -> child.children().stream()))
                .filter(child -> child.name().equals("field"))
                .forEach(this::declared));
    values.forEach((name, value) -> fields.computeIfAbsent(name, of -> undeclared(of, value)));
    return List.copyOf(fields.values());
  }

  private boolean body(DocumentElement child) {
    return child.name().equals("ProtoBody");
  }

  /** Finds the connections in a part of the body; another prototype has an interface of its own. */
  private void connect(DocumentElement within) {
    for (DocumentElement child : within.children()) {
      if (child.name().equals("connect")) {
        child.text("protoField").ifPresent(name -> connect(name, child));
      } else if (!child.name().equals("ProtoDeclare")) {
        connect(child);
      }
    }
  }

  private void connect(String name, DocumentElement connect) {
    Optional<DocumentElement> node = connect.parent().flatMap(DocumentElement::parent);
    node.flatMap(of -> catalogue.find(of.name()))
        .flatMap(type -> type.field(connect.text("nodeField").orElse("")))
        .ifPresent(field -> connections.putIfAbsent(name, new Connection(node.get(), field)));
  }

  /** Lists a field; of a long interface the first ones, and those that the instance gives. */
  private void declared(DocumentElement field) {
    String name = field.text("name").orElse("");
    if (name.isEmpty() || (fields.size() >= MANY && !values.containsKey(name))) {
      return;
    }
    String typeName = field.text("type").orElse("");
    String accessName = field.text("accessType").orElse("");
    Optional<FieldType> type =
        Stream.of(FieldType.values()).filter(each -> each.name().equals(typeName)).findFirst();
    Optional<AccessType> access =
        Stream.of(AccessType.values())
            .filter(each -> each.spelling().equals(accessName))
            .findFirst();
    if (type.isPresent() && access.filter(AccessType::initialisable).isPresent()) {
      FieldDefinition definition = definition(field, name, type.get(), access.get());
      fields.computeIfAbsent(name, of -> field(field, definition));
    } else if (values.containsKey(name)) {
      String wrong =
          type.isEmpty()
              ? "is declared with a type that does not exist: '" + typeName + "'."
              : access.isEmpty()
                  ? "is declared with an accessType that does not exist: '" + accessName + "'."
                  : "is " + accessName + ", so that an instance gives it no value.";
      refused.putIfAbsent(
          name, "The field " + name + " of the prototype " + prototype + " " + wrong);
    }
  }

  private FieldDefinition definition(
      DocumentElement field, String name, FieldType type, AccessType access) {
    Optional<Connection> connection =
        Optional.ofNullable(connections.get(name)).filter(of -> of.field().type() == type);
    Optional<FieldDefinition> like = connection.map(Connection::field);
    boolean bounded = like.filter(FieldValueConstraints::bounded).isPresent();
    List<String> words =
        connection
            .filter(of -> !FieldValueConstraints.open(of.node().name(), of.field()))
            .map(of -> of.field().values())
            .orElse(List.of());
    String initial =
        field
            .text("value")
            .or(() -> connection.flatMap(of -> of.node().text(of.field().name())))
            .or(() -> like.map(FieldDefinition::defaultText))
            .orElse("");
    return new FieldDefinition(
        0,
        name,
        type,
        access,
        initial.length() > LONG ? initial.substring(0, LONG) + " ..." : initial,
        bounded ? like.get().min() : "",
        bounded ? like.get().max() : "",
        words,
        List.of(),
        null);
  }

  private NodeField field(DocumentElement field, FieldDefinition definition) {
    String name = definition.name();
    Optional<DocumentElement> value = Optional.ofNullable(values.get(name));
    boolean holdsNodes = definition.type().isNode();
    InterfaceField own =
        new InterfaceField(
            prototype,
            field.text("appinfo").orElse("").strip(),
            Optional.empty(),
            declaration.filter(of -> of.name().equals("ExternProtoDeclare")).isPresent(),
            holdsNodes ? nodes(value.orElse(field)) : List.of());
    return made(name, Optional.of(definition), value, own, holdsNodes);
  }

  private NodeField undeclared(String name, DocumentElement value) {
    List<DocumentElement> nodes = nodes(value);
    InterfaceField own =
        new InterfaceField(
            prototype,
            "",
            declaration.map(
                of ->
                    refused.getOrDefault(
                        name, "The prototype %s has no field %s.".formatted(prototype, name))),
            false,
            nodes);
    return made(name, Optional.empty(), Optional.of(value), own, !nodes.isEmpty());
  }

  /** Returns the nodes in a value. */
  static List<DocumentElement> nodes(DocumentElement in) {
    return in.children().stream().filter(child -> !child.name().equals("IS")).toList();
  }

  private NodeField made(
      String name,
      Optional<FieldDefinition> definition,
      Optional<DocumentElement> value,
      InterfaceField own,
      boolean nodes) {
    if (nodes) {
      return new NodeField(
          name,
          NodeField.Kind.NODES,
          definition,
          value.map(of -> ""),
          List.of(),
          Optional.of(HOLDS_NODES),
          Optional.of(own));
    }
    Optional<SourceAttribute> written = value.flatMap(of -> document.tag(of).attribute("value"));
    Optional<String> readOnly = written.flatMap(NodeFieldList::readOnly);
    return new NodeField(
        name,
        NodeFieldList.isLong(written) ? NodeField.Kind.TEXT : NodeFieldList.kind(definition),
        definition,
        value.map(of -> written.map(NodeFieldList::shown).orElse("")),
        NodeFieldList.choices(definition),
        readOnly,
        Optional.of(own));
  }
}
