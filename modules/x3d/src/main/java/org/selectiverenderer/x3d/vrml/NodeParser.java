package org.selectiverenderer.x3d.vrml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.XmlParseException;
import org.selectiverenderer.x3d.vrml.VrmlScope.Named;

/** Parses nodes with their fields, and delegates other statements to {@link StatementParser}. */
final class NodeParser {
  /**
   * The place of a node in its parent.
   *
   * @param field the field of the parent; empty at the top level and in a prototype
   * @param at the offset of the field's name
   */
  record Place(String field, int at) {}

  /** The top level of a scene, and any other place without a field. */
  static final Place TOP = new Place("", 0);

  private record Connection(String field, String prototypeField, int at, int from, int to) {}

  private static final String INSTANCE = "ProtoInstance";

  private final ElementTreeBuilder document;
  private final VrmlScanner scanner;
  private final NodeCatalogue catalogue;
  private final ValueParser values;
  private final StatementParser statements;

  NodeParser(ElementTreeBuilder document, VrmlScanner scanner, NodeCatalogue catalogue) {
    this.document = document;
    this.scanner = scanner;
    this.catalogue = catalogue;
    this.values = new ValueParser(document, scanner);
    this.statements = new StatementParser(document, scanner, catalogue, this, values);
  }

  /** Parses the node or other statement at the current offset. */
  void statement(VrmlScope scope, Place place) throws XmlParseException {
    int start = scanner.at();
    String word = scanner.word();
    switch (word) {
      case "DEF" -> {
        String name = scanner.name("the name of a node");
        node(scope, place, start, scanner.name("the type of the node " + name), name);
      }
      case "USE" -> use(scope, place, start);
      case "NULL" -> {
        // no node
      }
      case "" -> throw scanner.expected("a node or a statement");
      default -> {
        if (!statements.read(word, start, scope)) {
          node(scope, place, start, word, null);
        }
      }
    }
  }

  private void use(VrmlScope scope, Place place, int start) throws XmlParseException {
    int from = scanner.space();
    String name = scanner.name("the name of a node");
    Named named = scope.find(name);
    String element = named == null ? INSTANCE : named.element();
    String def = scope.currentName(name);
    document.open(element, null, def, start, scanner.at());
    document.attribute("USE", def, start, from, scanner.at());
    if (named != null && !named.prototype().isEmpty()) {
      document.attribute("name", named.prototype(), start);
    }
    container(place);
    document.close(scanner.at());
  }

  private void container(Place place) {
    if (!place.field().isEmpty()) {
      document.container(place.field(), place.at());
    }
  }

  private void node(VrmlScope scope, Place place, int start, String word, @Nullable String name)
      throws XmlParseException {
    int behind = scanner.at();
    scanner.space();
    if (scanner.peek() != '{') {
      scanner.back(behind);
      scanner.space();
      throw scanner.expected("'{' after the type of a node, " + FieldTokenizer.quote(word) + ",");
    }
    scanner.step();
    Map<String, FieldType> fields = scope.prototype(word);
    NodeType type = fields != null ? null : catalogue.find(word).orElse(null);
    String element = fields != null ? INSTANCE : word;
    String def = name == null ? null : scope.nameForNewNode(name);
    if (name != null) {
      scope.define(name, new Named(element, fields != null ? word : ""));
    }
    document.open(element, def, null, start, scanner.at());
    if (fields != null) {
      document.attribute("name", word, start);
    }
    if (def != null) {
      document.attribute("DEF", def, start);
    }
    container(place);
    List<Connection> connections = new ArrayList<>(0);
    scanner.space();
    while (scanner.peek() != '}') {
      int at = scanner.at();
      String field = scanner.name("a field or '}'");
      boolean own =
          fields == null
              && (type == null || type.field("field").isPresent())
              && StatementParser.access(field) != null;
      if (own) {
        ownField(scope, field, at, connections);
      } else if (!statements.read(field, at, scope)) {
        field(scope, type, fields, field, at, connections);
      }
      scanner.space();
    }
    scanner.step();
    connect(connections);
    document.close(scanner.at());
  }

  private void ownField(VrmlScope scope, String access, int at, List<Connection> connections)
      throws XmlParseException {
    StatementParser.Declared declared = statements.declare(access, at);
    if (!connected(declared.name(), at, connections)) {
      statements.initial(declared, scope);
    }
    document.close(scanner.at());
  }

  private void field(
      VrmlScope scope,
      @Nullable NodeType type,
      @Nullable Map<String, FieldType> fields,
      String word,
      int at,
      List<Connection> connections)
      throws XmlParseException {
    String name = LegacyFieldNames.now(type, word);
    if (connected(name, at, connections)) {
      return;
    }
    if (fields != null) {
      int nameEnd = scanner.at();
      document.open("fieldValue", null, null, at, nameEnd);
      document.attribute("name", name, at, at, nameEnd);
      content(scope, TOP, "value", fields.get(name), at);
      document.close(scanner.at());
      return;
    }
    FieldType known =
        type == null ? null : type.field(name).map(FieldDefinition::type).orElse(null);
    content(scope, new Place(name, at), name, known, at);
  }

  /**
   * Parses the content of a field.
   *
   * @param place the place of its nodes
   * @param attribute the attribute for its value
   * @param type the field type, or null if it is unknown
   */
  void content(VrmlScope scope, Place place, String attribute, @Nullable FieldType type, int at)
      throws XmlParseException {
    if (type != null && !type.isNode()) {
      values.value(attribute, type, at);
    } else if (type != null && !values.numbers()) {
      nodes(scope, place);
    } else if (type != null && attribute.equals("controlPoint")) {
      controlPoints(at);
    } else if (!values.guess(attribute, at)) {
      nodes(scope, place);
    }
  }

  /** Parses control points of VRML97 NURBS, which are values (ISO/IEC 14772-1 Amd.1, 6). */
  private void controlPoints(int at) throws XmlParseException {
    document.open("Coordinate", null, null, at, scanner.at());
    document.attribute("containerField", "controlPoint", at);
    values.value("point", FieldType.MFVec3f, at);
    document.close(scanner.at());
  }

  private void nodes(VrmlScope scope, Place place) throws XmlParseException {
    int open = scanner.space();
    if (scanner.peek() != '[') {
      statement(scope, place);
      return;
    }
    scanner.step();
    scanner.space();
    while (scanner.peek() != ']') {
      if (scanner.ended() || scanner.peek() == '}') {
        throw document.fault(open, "the list of nodes that begins here has no closing ']'");
      }
      statement(scope, place);
      scanner.space();
    }
    scanner.step();
  }

  /** Parses an IS connection, if there is one here (ISO/IEC 19776-2, 4.3.7). */
  private boolean connected(String field, int at, List<Connection> connections)
      throws XmlParseException {
    scanner.space();
    if (!scanner.take("IS")) {
      return false;
    }
    int from = scanner.space();
    String outer = scanner.name("the name of a field of the prototype");
    connections.add(new Connection(field, outer, at, from, scanner.at()));
    return true;
  }

  private void connect(List<Connection> connections) throws XmlParseException {
    if (connections.isEmpty()) {
      return;
    }
    int start = connections.get(0).at();
    document.open("IS", null, null, start, start);
    for (Connection connection : connections) {
      int at = connection.at();
      document.open("connect", null, null, at, at);
      document.attribute("nodeField", connection.field(), at);
      document.attribute(
          "protoField", connection.prototypeField(), at, connection.from(), connection.to());
      document.close(connection.to());
    }
    document.close(connections.get(connections.size() - 1).to());
  }
}
