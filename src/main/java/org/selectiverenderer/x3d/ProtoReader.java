package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Reads prototypes and puts, for each instance, a copy of the prototype's body in its place (X3D
 * 4.0, 4.4.4). What comes out holds no prototypes any more: IS fields have their values, and ROUTEs
 * lead to the fields within.
 */
final class ProtoReader {
  /** An IS connection of an instance that has not been made yet. */
  private record Outer(String nodeField, ProtoDeclaration.Field field) {}

  private final Reading reading;
  private final NodeReader nodes;
  private final RouteReader routes;
  private final Set<RecordedElement> expanding = Collections.newSetFromMap(new IdentityHashMap<>());

  ProtoReader(Reading reading, NodeReader nodes, RouteReader routes) {
    this.reading = reading;
    this.nodes = nodes;
    this.routes = routes;
  }

  /** Reads a ProtoDeclare. */
  void declare(ElementCursor in, Scope scope) {
    Location location = in.location();
    String name = in.attribute("name");
    Map<String, ProtoDeclaration.Field> fields = new LinkedHashMap<>();
    RecordedElement body = null;
    while (in.next()) {
      switch (in.name()) {
        case "ProtoInterface" -> {
          while (in.next()) {
            ProtoDeclaration.Field field = field(in);
            if (field != null) {
              fields.put(field.name(), field);
            }
          }
        }
        case "ProtoBody" -> body = in.record();
        default -> {
          reading.error(
              in.location(),
              "a ProtoDeclare holds a ProtoInterface and a ProtoBody; "
                  + in.name()
                  + " is left out");
          in.skip();
        }
      }
    }
    if (name == null || body == null) {
      reading.error(location, "a ProtoDeclare needs a name and a ProtoBody; this one is left out");
      return;
    }
    scope.declare(new ProtoDeclaration(name, fields, body, scope));
  }

  private ProtoDeclaration.@Nullable Field field(ElementCursor in) {
    Location location = in.location();
    String name = in.attribute("name");
    String typeName = in.attribute("type");
    String accessName = in.attribute("accessType");
    FieldType type = null;
    for (FieldType candidate : FieldType.values()) {
      type = candidate.name().equals(typeName) ? candidate : type;
    }
    FieldAccess access = null;
    for (FieldAccess candidate : FieldAccess.values()) {
      access = candidate.spelling().equals(accessName) ? candidate : access;
    }
    if (!in.name().equals("field") || name == null || type == null || access == null) {
      reading.error(
          location,
          "a ProtoInterface holds field elements with name, type and accessType; this "
              + in.name()
              + " is left out");
      in.skip();
      return null;
    }
    int value = in.indexOf("value");
    Object parsed = value >= 0 && !type.isNode() ? in.attributeValue(value, type) : null;
    List<RecordedElement> children = in.record().children();
    return new ProtoDeclaration.Field(
        name, type, access, parsed, type.isNode() ? children : List.of());
  }

  /** Reads an ExternProtoDeclare, which is told and left out with its instances. */
  void declareExternal(ElementCursor in, Scope scope) {
    String name = in.attribute("name");
    reading.warning(
        in.location(),
        "prototypes of other files are not loaded; "
            + (name == null ? "this one" : name)
            + " is left out with all its instances");
    if (name != null) {
      scope.declareExternal(name);
    }
    in.skip();
  }

  /**
   * Reads a ProtoInstance.
   *
   * @param givenName the name of the instance whose body's first node this is, or null
   */
  NodeReader.@Nullable Child instance(ElementCursor in, Scope scope, @Nullable String givenName) {
    Location location = in.location();
    String use = in.attribute("USE");
    if (use != null) {
      return nodes.use(in, scope, use, "ProtoInstance");
    }
    String name = in.attribute("name");
    ProtoDeclaration declaration = name == null ? null : scope.prototype(name);
    if (name == null || declaration == null) {
      if (name == null || !scope.isExternal(name)) {
        reading.error(
            location,
            (name == null
                    ? "a ProtoInstance needs a name"
                    : "no prototype before this is called "
                        + name
                        + Spelling.question(name, scope.prototypeNames()))
                + "; the instance is left out");
      }
      in.skip();
      return null;
    }
    if (expanding.contains(declaration.body())) {
      reading.error(
          location, "the prototype " + name + " contains itself; this instance is left out");
      in.skip();
      return null;
    }
    String def = in.attribute("DEF");
    String containerField = in.attribute("containerField");
    ProtoInstance instance = new ProtoInstance(declaration);
    List<Outer> connections = arguments(in, scope, instance);
    ParsedNode node = expand(instance, givenName != null ? givenName : def, location);
    if (node == null) {
      return null;
    }
    Scope.Named named = new Scope.Named(node, instance);
    nodes.define(scope, def, named, location);
    ProtoInstance outer = scope.instance();
    for (Outer connection : connections) {
      if (outer != null) {
        outer.connect(
            connection.field().name(), new ProtoInstance.Connection(named, connection.nodeField()));
      }
    }
    return new NodeReader.Child(named, containerField, location);
  }

  private List<Outer> arguments(ElementCursor in, Scope scope, ProtoInstance instance) {
    List<Outer> connections = new ArrayList<>();
    while (in.next()) {
      switch (in.name()) {
        case "fieldValue" -> fieldValue(in, scope, instance);
        case "IS" -> {
          while (in.next()) {
            Outer connection = outer(in, scope);
            ProtoDeclaration.Field inner =
                connection == null
                    ? null
                    : instance.declaration().fields().get(connection.nodeField());
            ProtoInstance enclosing = scope.instance();
            if (connection != null && enclosing != null) {
              if (inner == null || inner.type() != connection.field().type()) {
                mismatch(in.location(), instance.declaration().name(), connection);
              } else {
                connections.add(connection);
                Object value = enclosing.value(connection.field());
                if (value != null) {
                  instance.give(inner.name(), value);
                }
              }
            }
            in.skip();
          }
        }
        default -> nodes.read(in, scope);
      }
    }
    return connections;
  }

  private void fieldValue(ElementCursor in, Scope scope, ProtoInstance instance) {
    String name = in.attribute("name");
    ProtoDeclaration declaration = instance.declaration();
    ProtoDeclaration.Field field = name == null ? null : declaration.fields().get(name);
    if (name == null || field == null) {
      reading.warning(
          in.location(),
          (name == null
                  ? "a fieldValue needs a name"
                  : "the prototype "
                      + declaration.name()
                      + " has no field "
                      + name
                      + Spelling.question(name, declaration.fields().keySet()))
              + "; the value is left out");
      in.skip();
      return;
    }
    int attribute = in.indexOf("value");
    Object value =
        attribute >= 0 && !field.type().isNode()
            ? in.attributeValue(attribute, field.type())
            : null;
    List<ParsedNode> given = new ArrayList<>();
    while (in.next()) {
      NodeReader.Child child = nodes.read(in, scope);
      if (child != null) {
        given.add(child.node());
      }
    }
    if (field.type().isNode()) {
      value = nodeValue(field.type(), given);
    }
    if (value != null) {
      instance.give(field.name(), value);
    }
  }

  private static @Nullable Object nodeValue(FieldType type, List<ParsedNode> given) {
    return type.multiple() ? List.copyOf(given) : given.isEmpty() ? null : given.get(0);
  }

  /** Makes the nodes of an instance and returns the first of the body, or null after a message. */
  private @Nullable ParsedNode expand(
      ProtoInstance instance, @Nullable String name, Location location) {
    ProtoDeclaration declaration = instance.declaration();
    Scope scope = new Scope(declaration.environment(), instance);
    expanding.add(declaration.body());
    reading.startReplay();
    ParsedNode first = null;
    defaults(instance, scope);
    ElementCursor body = declaration.body().cursor(reading);
    while (body.next()) {
      NodeReader.Child child = nodes.read(body, scope, first == null ? name : null);
      first = first == null && child != null ? child.node() : first;
    }
    routes.connect(scope);
    reading.endReplay();
    expanding.remove(declaration.body());
    if (first == null) {
      reading.error(
          location,
          "the body of the prototype "
              + declaration.name()
              + " has no node; the instance is left out");
    }
    return first;
  }

  private void defaults(ProtoInstance instance, Scope scope) {
    for (ProtoDeclaration.Field field : instance.declaration().fields().values()) {
      if (field.type().isNode()
          && field.access().initialisable()
          && !instance.given(field.name())) {
        List<ParsedNode> given = new ArrayList<>();
        for (RecordedElement element : field.nodes()) {
          NodeReader.Child child = nodes.read(element.cursor(reading), scope);
          if (child != null) {
            given.add(child.node());
          }
        }
        Object value = nodeValue(field.type(), given);
        if (value != null) {
          instance.give(field.name(), value);
        }
      }
    }
  }

  /** Reads the IS element of a node in a prototype's body: gives it the instance's values. */
  void connect(ElementCursor in, Scope scope, Scope.Named named, Children children) {
    ProtoInstance instance = scope.instance();
    ParsedNode node = named.node();
    while (in.next()) {
      Outer connection = outer(in, scope);
      if (connection != null && instance != null) {
        String name = connection.nodeField();
        FieldDefinition field =
            node.type()
                .field(name)
                .or(() -> node.type().input(name))
                .or(() -> node.type().output(name))
                .orElse(null);
        boolean own = field == null && node.type().field("field").isPresent();
        if (field != null && field.type() == connection.field().type()) {
          instance.connect(connection.field().name(), new ProtoInstance.Connection(named, name));
          give(node, field, instance.value(connection.field()), children, in.location());
        } else if (!own) {
          mismatch(in.location(), node.type().name(), connection);
        }
      }
      in.skip();
    }
  }

  private void give(
      ParsedNode node,
      FieldDefinition field,
      @Nullable Object value,
      Children children,
      Location location) {
    if (value == null || !field.access().initialisable()) {
      return;
    }
    if (!field.type().isNode()) {
      node.put(field.index(), value);
      return;
    }
    List<?> given = value instanceof List<?> list ? list : List.of(value);
    for (Object child : given) {
      ParsedNode childNode = (ParsedNode) child;
      if (Children.accepts(field, childNode.type())) {
        children.put(field, childNode, location);
      } else {
        reading.error(
            location,
            "a "
                + childNode.type()
                + " cannot be the "
                + field.name()
                + " of a "
                + node.type()
                + "; it is left out");
      }
    }
  }

  /** Reads the attributes of a connect element, or tells what is wrong with it. */
  private @Nullable Outer outer(ElementCursor in, Scope scope) {
    ProtoInstance instance = scope.instance();
    String nodeField = in.attribute("nodeField");
    String protoField = in.attribute("protoField");
    if (instance == null) {
      reading.error(
          in.location(), "IS has a meaning in the body of a prototype only; it is left out");
      return null;
    }
    if (!in.name().equals("connect") || nodeField == null || protoField == null) {
      reading.error(
          in.location(),
          "IS holds connect elements with nodeField and protoField; this one is left out");
      return null;
    }
    ProtoDeclaration.Field field = instance.declaration().fields().get(protoField);
    if (field == null) {
      reading.error(
          in.location(),
          "the prototype "
              + instance.declaration().name()
              + " has no field "
              + protoField
              + Spelling.question(protoField, instance.declaration().fields().keySet())
              + "; the connection is left out");
      return null;
    }
    return new Outer(nodeField, field);
  }

  private void mismatch(Location location, String owner, Outer connection) {
    reading.error(
        location,
        owner
            + " has no field "
            + connection.nodeField()
            + " of type "
            + connection.field().type()
            + "; the connection is left out");
  }
}
