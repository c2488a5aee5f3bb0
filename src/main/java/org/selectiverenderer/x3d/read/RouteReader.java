package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;

/** Reads ROUTE elements and finds out what they connect (X3D 4.0, 4.4.8.2). */
final class RouteReader {
  private record Field(ParsedNode node, FieldDefinition definition) {}

  private final ReadState reading;
  private final List<X3dFile.ParsedRoute> routes = new ArrayList<>();

  RouteReader(ReadState reading) {
    this.reading = reading;
  }

  List<X3dFile.ParsedRoute> routes() {
    return routes;
  }

  /** Reads the current element; its ends are checked at the end of the scope. */
  void read(ElementCursor in, NameScope scope) {
    Location location = in.location();
    PendingRoute.End from = end(in, scope, "fromNode", "fromField");
    PendingRoute.End to = end(in, scope, "toNode", "toField");
    if (from == null || to == null) {
      reading.error(
          location, "a ROUTE needs fromNode, fromField, toNode and toField; this one is left out");
    } else {
      scope.add(new PendingRoute(from, to, location));
    }
    in.skip();
  }

  private static PendingRoute.@Nullable End end(
      ElementCursor in, NameScope scope, String nodeAttribute, String fieldAttribute) {
    String node = in.attribute(nodeAttribute);
    String field = in.attribute(fieldAttribute);
    return node == null || field == null
        ? null
        : new PendingRoute.End(node, field, scope.find(node));
  }

  /** Connects the ROUTEs of a scope whose nodes have all been read. */
  void connect(NameScope scope) {
    for (PendingRoute route : scope.routes()) {
      List<Field> sources = fields(scope, route, route.from(), false);
      List<Field> targets = sources == null ? null : fields(scope, route, route.to(), true);
      if (sources == null || targets == null) {
        continue;
      }
      for (Field source : sources) {
        for (Field target : targets) {
          connect(route, source, target);
        }
      }
    }
  }

  private void connect(PendingRoute route, Field source, Field target) {
    FieldType from = source.definition().type();
    FieldType to = target.definition().type();
    if (from != to) {
      leaveOut(route, route.from() + " is " + from + " and " + route.to() + " is " + to);
    } else if (reading.spend(route.location())) {
      routes.add(
          new X3dFile.ParsedRoute(
              source.node(),
              source.definition().index(),
              target.node(),
              target.definition().index()));
    }
  }

  /** The fields that an end stands for, or null after a message. */
  private @Nullable List<Field> fields(
      NameScope scope, PendingRoute route, PendingRoute.End end, boolean input) {
    NameScope.Named named = end.found() != null ? end.found() : scope.find(end.node());
    if (named == null) {
      if (scope.isImported(end.node())) {
        reading.warning(
            route.location(),
            "routes to and from imported nodes are not followed; this one, "
                + route.from()
                + " to "
                + route.to()
                + ", is left out");
      } else {
        leaveOut(
            route,
            "no node has the name "
                + end.node()
                + reading.question(end.node(), scope.names().keySet()));
      }
      return null;
    }
    List<Field> found = new ArrayList<>(1);
    if (resolve(named, end.field(), input, found)) {
      return found;
    }
    leaveOut(route, why(named, end, input));
    return null;
  }

  private String why(NameScope.Named named, PendingRoute.End end, boolean input) {
    ProtoInstance instance = named.instance();
    String owner = instance == null ? named.node().type().name() : instance.declaration().name();
    List<String> names =
        instance == null
            ? named.node().type().fields().stream().map(FieldDefinition::name).toList()
            : List.copyOf(instance.declaration().fields().keySet());
    return names.contains(end.field())
        ? end + (input ? " does not receive events" : " does not send events")
        : owner + " has no field " + end.field() + reading.question(end.field(), names);
  }

  /**
   * Adds the fields that a name of a node stands for: one, or for an instance all those that its
   * body connects. False if it has no such field.
   */
  private boolean resolve(NameScope.Named named, String field, boolean input, List<Field> into) {
    ProtoInstance instance = named.instance();
    if (instance == null) {
      NodeType type = named.node().type();
      FieldDefinition definition = (input ? type.input(field) : type.output(field)).orElse(null);
      if (definition != null) {
        into.add(new Field(named.node(), definition));
      }
      return definition != null;
    }
    ProtoDeclaration.Field declared = instance.declaration().event(field, input);
    if (declared == null) {
      return false;
    }
    for (ProtoInstance.Connection connection : instance.connections(declared.name())) {
      // A connected field of the other direction only is no fault of the ROUTE.
      resolve(connection.node(), connection.field(), input, into);
    }
    return true;
  }

  private void leaveOut(PendingRoute route, String why) {
    reading.error(
        route.location(),
        why + "; the ROUTE " + route.from() + " to " + route.to() + " is left out");
  }
}
