package org.selectiverenderer.x3d.vrml;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.XmlParseException;

/** Parses routes, prototypes, imports and exports (ISO/IEC 19776-2, 4.3.4 to 4.3.13). */
final class StatementParser {
  /** A field declaration of a prototype or Script, whose element is open. */
  record Declared(String name, FieldType type, AccessType access, int at) {}

  private final ElementTreeBuilder document;
  private final VrmlScanner scanner;
  private final NodeCatalogue catalogue;
  private final NodeParser nodes;
  private final ValueParser values;

  StatementParser(
      ElementTreeBuilder document,
      VrmlScanner scanner,
      NodeCatalogue catalogue,
      NodeParser nodes,
      ValueParser values) {
    this.document = document;
    this.scanner = scanner;
    this.catalogue = catalogue;
    this.nodes = nodes;
    this.values = values;
  }

  /** Returns the access type of a keyword of X3D or VRML97; null for any other word. */
  static @Nullable AccessType access(String word) {
    return switch (word) {
      case "field", "initializeOnly" -> AccessType.INITIALIZE_ONLY;
      case "eventIn", "inputOnly" -> AccessType.INPUT_ONLY;
      case "eventOut", "outputOnly" -> AccessType.OUTPUT_ONLY;
      case "exposedField", "inputOutput" -> AccessType.INPUT_OUTPUT;
      default -> null;
    };
  }

  /**
   * Parses the statement of a keyword; returns false for any other word.
   *
   * @param start the offset of the word, which has been consumed
   */
  boolean read(String word, int start, VrmlScope scope) throws XmlParseException {
    switch (word) {
      case "ROUTE" -> route(start, scope);
      case "PROTO" -> prototype(start, scope);
      case "EXTERNPROTO" -> external(start, scope);
      case "IMPORT" -> imported(start);
      case "EXPORT" -> exported(start);
      case "PROFILE", "COMPONENT", "META", "UNIT" ->
          throw document.fault(start, word + " must stand before the first node of a scene");
      default -> {
        return false;
      }
    }
    return true;
  }

  private void route(int start, VrmlScope scope) throws XmlParseException {
    document.open("ROUTE", null, null, start, scanner.at());
    end(start, scope, "from");
    scanner.space();
    if (!scanner.take("TO")) {
      throw scanner.expected("TO and the destination of the ROUTE");
    }
    end(start, scope, "to");
    document.close(scanner.at());
  }

  private void end(int start, VrmlScope scope, String side) throws XmlParseException {
    int node = scanner.space();
    String name = scanner.word('.');
    document.attribute(side + "Node", scope.currentName(name), start, node, scanner.at());
    scanner.expect('.', "between a node and its field, as in ROUTE Clock.isActive TO Light.on,");
    int field = scanner.space();
    String written = scanner.name("the name of a field");
    VrmlScope.Named named = scope.find(name);
    String now =
        named == null
            ? written
            : LegacyFieldNames.now(catalogue.find(named.element()).orElse(null), written);
    document.attribute(side + "Field", now, start, field, scanner.at());
  }

  private void imported(int start) throws XmlParseException {
    document.open("IMPORT", null, null, start, scanner.at());
    int inline = scanner.space();
    String name = scanner.word('.');
    document.attribute("inlineDEF", name, start, inline, scanner.at());
    scanner.expect('.', "between an Inline and a name that its file exports");
    name("importedDEF", start);
    as(start);
    document.close(scanner.at());
  }

  private void exported(int start) throws XmlParseException {
    document.open("EXPORT", null, null, start, scanner.at());
    name("localDEF", start);
    as(start);
    document.close(scanner.at());
  }

  private void as(int start) throws XmlParseException {
    if (scanner.nextWord().equals("AS")) {
      scanner.space();
      scanner.passWord();
      name("AS", start);
    }
  }

  private String name(String attribute, int start) throws XmlParseException {
    int from = scanner.space();
    String name = scanner.name("a name");
    document.attribute(attribute, name, start, from, scanner.at());
    return name;
  }

  private void prototype(int start, VrmlScope scope) throws XmlParseException {
    document.open("ProtoDeclare", null, null, start, scanner.at());
    String name = name("name", start);
    Map<String, FieldType> fields = new HashMap<>();
    scanner.expect('[', "and the interface of the prototype " + FieldTokenizer.quote(name));
    document.open("ProtoInterface", null, null, scanner.at() - 1, scanner.at());
    scanner.space();
    while (scanner.peek() != ']') {
      int at = scanner.at();
      Declared declared = declare(scanner.name("a field or ']'"), at);
      fields.put(declared.name(), declared.type());
      initial(declared, scope);
      document.close(scanner.at());
      scanner.space();
    }
    scanner.step();
    document.close(scanner.at());
    scanner.expect('{', "and the body of the prototype " + FieldTokenizer.quote(name));
    document.open("ProtoBody", null, null, scanner.at() - 1, scanner.at());
    VrmlScope body = scope.ofPrototype();
    scanner.space();
    while (scanner.peek() != '}') {
      nodes.statement(body, NodeParser.TOP);
      scanner.space();
    }
    scanner.step();
    document.close(scanner.at());
    document.close(scanner.at());
    scope.declare(name, fields);
  }

  private void external(int start, VrmlScope scope) throws XmlParseException {
    document.open("ExternProtoDeclare", null, null, start, scanner.at());
    String name = name("name", start);
    Map<String, FieldType> fields = new HashMap<>();
    scanner.expect('[', "and the interface of the prototype " + FieldTokenizer.quote(name));
    scanner.space();
    while (scanner.peek() != ']') {
      int at = scanner.at();
      Declared declared = declare(scanner.name("a field or ']'"), at);
      fields.put(declared.name(), declared.type());
      document.close(scanner.at());
      scanner.space();
    }
    scanner.step();
    values.value("url", FieldType.MFString, scanner.space());
    document.close(scanner.at());
    scope.declare(name, fields);
  }

  /**
   * Parses a field declaration of an interface and opens its element.
   *
   * @param word the keyword of its access type, which has been consumed
   * @param at the offset of the keyword
   */
  Declared declare(String word, int at) throws XmlParseException {
    AccessType access = access(word);
    if (access == null) {
      throw document.fault(
          at,
          "inputOnly, outputOnly, inputOutput or initializeOnly is expected here, not "
              + FieldTokenizer.quote(word));
    }
    int from = scanner.space();
    String spelling = scanner.name("the type of a field");
    FieldType type = null;
    for (FieldType candidate : FieldType.values()) {
      type = candidate.name().equals(spelling) ? candidate : type;
    }
    if (type == null) {
      throw document.fault(from, FieldTokenizer.quote(spelling) + " is not a field type");
    }
    int typeEnd = scanner.at();
    document.open("field", null, null, at, typeEnd);
    String name = name("name", at);
    document.attribute("type", spelling, at, from, typeEnd);
    document.attribute("accessType", access.spelling(), at);
    return new Declared(name, type, access, at);
  }

  /** Parses the initial value of a field, if it has one. */
  void initial(Declared declared, VrmlScope scope) throws XmlParseException {
    if (declared.access().initialisable()) {
      nodes.content(scope, NodeParser.TOP, "value", declared.type(), declared.at());
    }
  }
}
