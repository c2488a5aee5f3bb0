package org.selectiverenderer.x3d.read;

import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParseErrors;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.ElementLocation;

/** Reads node elements, and delegates statements among them to their readers. */
final class NodeReader {
  /**
   * A node with its containerField.
   *
   * @param containerField the value in the file, or null
   */
  record Child(NameScope.Named named, @Nullable String containerField, SourceLocation location) {
    ParsedNode node() {
      return named.node();
    }
  }

  /** Reads IMPORT and EXPORT, which belong to the file as a whole. */
  interface Links {
    /** Reads the attributes of the current element. */
    void link(ElementCursor in);
  }

  /** The schemes of inline programs in a url (ISO/IEC 19777-1, 4.2; VRML97, C.1). */
  private static final Pattern PROGRAM =
      Pattern.compile("(?i)\\b(ecmascript|javascript|vrmlscript):");

  private final ReadContext reading;
  private final RouteReader routes;
  private final Links links;
  private final ProtoDeclarationReader declarations;
  private final ProtoInstanceExpander instances;
  private final IsStatementReader connecting;

  NodeReader(ReadContext reading, RouteReader routes, Links links) {
    this.reading = reading;
    this.routes = routes;
    this.links = links;
    this.declarations = new ProtoDeclarationReader(reading);
    this.connecting = new IsStatementReader(reading);
    this.instances = new ProtoInstanceExpander(reading, this, routes, connecting);
  }

  /** Reads the current element to its end; null if it is not a node or is left out. */
  @Nullable Child read(ElementCursor in, NameScope scope) {
    return read(in, scope, null);
  }

  /**
   * Reads the current element, which may be the first node of a prototype's body.
   *
   * @param name the instance's DEF name, which replaces that of the node, or null
   */
  @Nullable Child read(ElementCursor in, NameScope scope, @Nullable String name) {
    if (!reading.enter(in.location())) {
      in.skip();
      return null;
    }
    try {
      switch (in.name()) {
        case "ROUTE" -> routes.read(in, scope);
        case "ProtoDeclare" -> declarations.declare(in, scope);
        case "ExternProtoDeclare" -> declarations.declareExternal(in, scope);
        case "ProtoInstance" -> {
          return instances.instance(in, scope, name);
        }
        case "IMPORT", "EXPORT" -> {
          links.link(in);
          in.skip();
        }
        default -> {
          NodeType type = reading.catalogue.find(in.name()).orElse(null);
          if (type != null) {
            return node(in, scope, type, name);
          }
          if (!in.foreign()) {
            reading.error(
                in.location(),
                "unknown element "
                    + in.name()
                    + reading.question(in.name(), reading.catalogue.names())
                    + "; it and its children are left out");
          }
          lose(in, scope);
        }
      }
      return null;
    } finally {
      reading.leave();
    }
  }

  private @Nullable Child node(
      ElementCursor in, NameScope scope, NodeType type, @Nullable String givenName) {
    SourceLocation location = in.location();
    String use = in.attribute("USE");
    if (use != null) {
      return use(in, scope, use, type.name());
    }
    if (!reading.spend(location)) {
      in.skip();
      return null;
    }
    String def = in.attribute("DEF");
    String containerField = in.attribute("containerField");
    ParsedNode node =
        new ParsedNode(type, givenName != null ? givenName : def, location, reading.base());
    NameScope.Named named = new NameScope.Named(node, null);
    define(scope, def, named, location);
    attributes(in, node);
    scope.open(node);
    content(in, scope, named);
    scope.close(node);
    return new Child(named, containerField, location);
  }

  /** Defines the DEF name of a node in a scope, if it has one. */
  void define(
      NameScope scope, @Nullable String def, NameScope.Named named, SourceLocation location) {
    if (def == null) {
      return;
    }
    NameScope.Named before = scope.define(def, named);
    if (before != null) {
      reading.warning(
          location,
          "the name "
              + def
              + " is used already at "
              + before.node().location()
              + "; from here on it means this "
              + named.node().type());
    }
  }

  /** Reads an element with USE, and returns the node of that name. */
  @Nullable Child use(ElementCursor in, NameScope scope, String name, String element) {
    ElementLocation place = in.place();
    int attribute = in.indexOf("USE");
    String containerField = in.attribute("containerField");
    in.skip();
    NameScope.Named found = scope.find(name);
    if (found == null && scope.isLost(name)) {
      return null;
    }
    if (found == null) {
      reading.error(
          reading.at(place, attribute),
          "no node above has the name "
              + name
              + reading.question(name, scope.names().keySet())
              + "; the USE is left out");
      return null;
    }
    if (scope.isOpen(found.node()) && scope.valued()) {
      reading.turnBack();
    } else if (scope.isOpen(found.node())) {
      reading.error(
          reading.at(place, attribute), name + " would contain itself here; the USE is left out");
      return null;
    }
    String kind = found.instance() != null ? "ProtoInstance" : found.node().type().name();
    if (!kind.equals(element)) {
      reading.warning(
          reading.at(place, attribute),
          "%s is %s, not %s; the %s is used"
              .formatted(name, SpellingSuggester.one(kind), SpellingSuggester.one(element), kind));
    }
    return new Child(found, containerField, place.location());
  }

  /** Skips an element and marks its names, so that references to them cause no message. */
  private static void lose(ElementCursor in, NameScope scope) {
    loseName(in, scope);
    for (int depth = 1; depth > 0; ) {
      if (in.next()) {
        loseName(in, scope);
        depth++;
      } else {
        depth--;
      }
    }
  }

  private static void loseName(ElementCursor in, NameScope scope) {
    String def = in.attribute("DEF");
    if (def != null) {
      scope.lose(def);
    }
  }

  private void attributes(ElementCursor in, ParsedNode node) {
    NodeType type = node.type();
    for (int i = 0; i < in.attributes(); i++) {
      String name = in.attributeName(i);
      FieldDefinition field = type.field(LegacyFieldNames.now(type, name)).orElse(null);
      if (field == null) {
        switch (name) {
          case "DEF", "USE", "containerField", "class", "id", "style", "" -> {
            // attributes of the XML encoding and of foreign namespaces
          }
          default ->
              reading.warning(
                  reading.at(in.place(), i),
                  type
                      + " has no field "
                      + name
                      + reading.question(
                          name, type.fields().stream().map(FieldDefinition::name).toList())
                      + "; it is left out");
        }
      } else if (field.type().isNode()) {
        reading.warning(
            reading.at(in.place(), i),
            name + " of " + type + " must be a child element; the attribute is left out");
      } else if (!field.access().initialisable()) {
        reading.warning(
            reading.at(in.place(), i),
            name
                + " of "
                + type
                + " is for events and cannot have a value in a file; it is left out");
      } else {
        Object value =
            reading.angles().radians(type.name(), field, in.attributeValue(i, field.type()));
        if (value != null) {
          node.put(field.index(), value);
        }
        if (name.equals("url") && type.is("X3DScriptNode")) {
          program(in, i, node);
        }
      }
    }
  }

  /**
   * Records where an inline program in a {@code url} begins, and restores its line ends, which XML
   * attribute normalization removed but which end comments after {@code //}.
   */
  private void program(ElementCursor in, int attribute, ParsedNode node) {
    Matcher scheme = PROGRAM.matcher(in.attributeText(attribute));
    if (scheme.find()) {
      int leading = FieldTokenizer.leading(in.attributeText(attribute));
      node.textLocation(in.place().inAttribute(attribute, scheme.end() - leading));
      String lines = in.place().attributeLines(attribute);
      // JSON has its lines in escapes already
      boolean normalized =
          lines.replace('\n', ' ').equals(in.attributeText(attribute).replace('\n', ' '));
      if (lines.indexOf('\n') >= 0 && normalized) {
        Object urls = reading.parser.parse(FieldType.MFString, lines, new FieldParseErrors());
        node.put(node.type().indexOf("url"), Objects.requireNonNull(urls));
      }
    }
  }

  private void content(ElementCursor in, NameScope scope, NameScope.Named named) {
    ParsedNode node = named.node();
    FieldDefinition source = node.type().field("sourceCode").orElse(null);
    ElementTextCollector text = null;
    if (source != null) {
      text = new ElementTextCollector();
      in.collectText(text);
    }
    AuthorDefinedFieldReader own =
        node.type().field("field").isPresent() ? new AuthorDefinedFieldReader(node, reading) : null;
    ChildNodeAssigner children = new ChildNodeAssigner(node, reading);
    while (in.next()) {
      if (in.name().equals("field") && own != null) {
        own.read(in, scope, this);
      } else if (in.name().equals("IS") && own != null) {
        own.connectLater(in);
      } else if (in.name().equals("IS")) {
        connecting.connect(in, scope, named, children);
      } else {
        Child child = read(in, scope);
        if (child != null) {
          children.add(child.node(), child.containerField(), child.location());
        }
      }
    }
    if (own != null) {
      own.declare();
      ProtoInstance within = scope.instance();
      if (within != null && node.type().is("X3DScriptNode")) {
        reading.interfaces.script(node, within);
      }
      own.connections()
          .forEach(is -> connecting.connect(TreeCursor.at(is, reading), scope, named, children));
    }
    children.finish();
    SourceLocation start = text == null ? null : text.start();
    if (start != null) {
      node.put(source.index(), text.text().strip());
      node.textLocation(start);
    }
  }
}
