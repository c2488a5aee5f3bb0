package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.BaseUrl;

/**
 * Expands prototype instances: replaces each by a copy of the prototype's body (X3D 4.0, 4.4.4).
 * The result has no prototypes: fields connected by IS have their values, and ROUTEs lead to the
 * fields of the nodes in the body.
 */
final class ProtoInstanceExpander {
  private final ReadContext reading;
  private final NodeReader nodes;
  private final RouteReader routes;
  private final IsStatementReader connecting;
  private final ExternProtoResolver externs;
  private final PrototypeNodeCounter sizes;
  private final Set<DocumentElement> expanding = Collections.newSetFromMap(new IdentityHashMap<>());

  ProtoInstanceExpander(
      ReadContext reading, NodeReader nodes, RouteReader routes, IsStatementReader connecting) {
    this.reading = reading;
    this.nodes = nodes;
    this.routes = routes;
    this.connecting = connecting;
    externs = new ExternProtoResolver(reading);
    sizes = new PrototypeNodeCounter(reading.catalogue, externs, reading.limits.maxDepth());
  }

  /**
   * Reads a ProtoInstance.
   *
   * @param givenName the name of the outer instance, if this is the first node of its body, or null
   */
  NodeReader.@Nullable Child instance(
      ElementCursor in, NameScope scope, @Nullable String givenName) {
    SourceLocation location = in.location();
    String use = in.attribute("USE");
    if (use != null) {
      return nodes.use(in, scope, use, "ProtoInstance");
    }
    String name = in.attribute("name");
    String def = in.attribute("DEF");
    ProtoDeclaration declaration = declaration(scope, name, location);
    if (declaration == null) {
      if (def != null) {
        scope.lose(def);
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
    if (!reading.spend(location) || !fits(declaration, location)) {
      if (def != null) {
        scope.lose(def);
      }
      in.skip();
      return null;
    }
    String containerField = in.attribute("containerField");
    ProtoInstance instance =
        new ProtoInstance(declaration, reading.interfaces.begin(), scope.instance(), location);
    List<IsStatementReader.Connection> connections = arguments(in, scope, instance);
    ParsedNode node = expand(instance, givenName != null ? givenName : def, location);
    if (node == null) {
      return null;
    }
    NameScope.Named named = new NameScope.Named(node, instance);
    nodes.define(scope, def, named, location);
    ProtoInstance outer = scope.instance();
    for (IsStatementReader.Connection connection : connections) {
      if (outer != null) {
        outer.connect(
            connection.field().name(), new ProtoInstance.Connection(named, connection.nodeField()));
      }
    }
    return new NodeReader.Child(named, containerField, location);
  }

  /** Returns whether the nodes of an instance are within the limit; false after a message. */
  private boolean fits(ProtoDeclaration declaration, SourceLocation location) {
    if (sizes.of(declaration) <= reading.left()) {
      return true;
    }
    reading.error(
        location,
        "this instance of the prototype %s exceeds the limit of %s nodes in a file; it is left out"
            .formatted(declaration.name(), reading.limits.maxNodes()));
    return false;
  }

  /** Returns the prototype of a name in a scope; null after a message. */
  private @Nullable ProtoDeclaration declaration(
      NameScope scope, @Nullable String name, SourceLocation location) {
    DeclaredPrototype prototype = name == null ? null : scope.prototype(name);
    if (prototype instanceof ExternProtoDeclaration extern) {
      return externs.find(extern);
    }
    if (prototype == null) {
      reading.error(
          location,
          (name == null
                  ? "a ProtoInstance needs a name"
                  : "no prototype above has the name "
                      + name
                      + reading.question(name, () -> scope.prototypeNames().iterator()))
              + "; the instance is left out");
    }
    return (ProtoDeclaration) prototype;
  }

  private List<IsStatementReader.Connection> arguments(
      ElementCursor in, NameScope scope, ProtoInstance instance) {
    List<IsStatementReader.Connection> connections = new ArrayList<>();
    while (in.next()) {
      switch (in.name()) {
        case "fieldValue" -> fieldValue(in, scope, instance);
        case "IS" -> connections.addAll(connecting.arguments(in, scope, instance));
        default -> nodes.read(in, scope);
      }
    }
    return connections;
  }

  private void fieldValue(ElementCursor in, NameScope scope, ProtoInstance instance) {
    String name = in.attribute("name");
    ProtoDeclaration declaration = instance.declaration();
    ProtoDeclaration.Field field = name == null ? null : declaration.fields().get(name);
    if (name != null && declaration.lacking().contains(name)) {
      in.skip();
      return;
    }
    if (name == null || field == null) {
      reading.warning(
          in.location(),
          (name == null
                  ? "a fieldValue needs a name"
                  : "the prototype "
                      + declaration.name()
                      + " has no field "
                      + name
                      + reading.question(name, declaration.fields().keySet()))
              + "; the value is left out");
      in.skip();
      return;
    }
    int attribute = in.indexOf("value");
    Object value =
        attribute >= 0 && !field.type().isNode()
            ? reading.angles().radians(field.type(), in.attributeValue(attribute, field.type()))
            : null;
    List<ParsedNode> given = new ArrayList<>();
    boolean outer = scope.valued(true);
    while (in.next()) {
      long turned = reading.turns();
      NodeReader.Child child = nodes.read(in, scope);
      if (child != null) {
        given.add(child.node());
        if (reading.turns() > turned) {
          instance.turnsBack(child.node());
        }
      }
    }
    scope.valued(outer);
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

  /** Creates the nodes of an instance; returns the first of the body, or null after a message. */
  private @Nullable ParsedNode expand(
      ProtoInstance instance, @Nullable String name, SourceLocation location) {
    ProtoDeclaration declaration = instance.declaration();
    NameScope scope = new NameScope(declaration.environment(), instance);
    expanding.add(declaration.body());
    BaseUrl outside = reading.base();
    AngleUnit unitOutside = reading.angles();
    reading.base(declaration.base());
    reading.angles(declaration.angles());
    reading.startReplay();
    List<ParsedNode> top = new ArrayList<>(1);
    defaults(instance, scope);
    ElementCursor body = TreeCursor.at(declaration.body(), reading);
    while (body.next()) {
      NodeReader.Child child = nodes.read(body, scope, top.isEmpty() ? name : null);
      if (child != null) {
        top.add(child.node());
        if (top.size() > 1 && child.node().type().is("X3DScriptNode")) {
          reading.loose(child.node());
        }
      }
    }
    routes.connect(scope);
    reading.endReplay();
    reading.base(outside);
    reading.angles(unitOutside);
    expanding.remove(declaration.body());
    if (top.isEmpty() && reading.left() == 0) {
      return null; // its nodes are beyond the limit, which is reported
    }
    if (top.isEmpty()) {
      reading.error(
          location,
          "the body of the prototype "
              + declaration.name()
              + " has no node; the instance is left out");
      return null;
    }
    reading.interfaces.end(instance, top);
    return top.get(0);
  }

  private void defaults(ProtoInstance instance, NameScope scope) {
    for (ProtoDeclaration.Field field : instance.declaration().fields().values()) {
      if (field.type().isNode()
          && field.access().initialisable()
          && !instance.given(field.name())) {
        List<ParsedNode> given = new ArrayList<>();
        for (DocumentElement element : field.nodes()) {
          NodeReader.Child child = nodes.read(TreeCursor.at(element, reading), scope);
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
}
