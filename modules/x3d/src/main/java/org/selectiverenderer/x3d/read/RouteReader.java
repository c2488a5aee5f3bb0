package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;

/** Reads ROUTE elements and resolves their fields (X3D 4.0, 4.4.8.2). */
final class RouteReader {
  private final ReadContext reading;
  private final List<X3dFile.ParsedRoute> routes = new ArrayList<>();
  private final List<X3dFile.ImportedRoute> imported = new ArrayList<>();

  RouteReader(ReadContext reading) {
    this.reading = reading;
  }

  List<X3dFile.ParsedRoute> routes() {
    return routes;
  }

  /** Returns the routes to or from imported nodes. */
  List<X3dFile.ImportedRoute> imported() {
    return imported;
  }

  /** Returns the node fields of an instance's fields, for ROUTEs of other files. */
  X3dFile.InstanceFields fields(NameScope.Named named, ProtoInstance instance) {
    Map<String, List<X3dFile.End.Own>> inputs = new HashMap<>();
    Map<String, List<X3dFile.End.Own>> outputs = new HashMap<>();
    for (String name : instance.declaration().fields().keySet()) {
      for (String spelling : List.of(name, "set_" + name, name + "_changed")) {
        List<X3dFile.End.Own> taking = new ArrayList<>();
        if (resolve(named, spelling, true, taking)) {
          inputs.put(spelling, List.copyOf(taking));
        }
        List<X3dFile.End.Own> sending = new ArrayList<>();
        if (resolve(named, spelling, false, sending)) {
          outputs.put(spelling, List.copyOf(sending));
        }
      }
    }
    return new X3dFile.InstanceFields(Map.copyOf(inputs), Map.copyOf(outputs));
  }

  /** Reads the current element; it is resolved at the end of the scope. */
  void read(ElementCursor in, NameScope scope) {
    SourceLocation location = in.location();
    UnresolvedRoute.End from = end(in, scope, "fromNode", "fromField");
    UnresolvedRoute.End to = end(in, scope, "toNode", "toField");
    if (from == null || to == null) {
      reading.error(
          location, "a ROUTE needs fromNode, fromField, toNode and toField; this one is left out");
    } else {
      scope.add(new UnresolvedRoute(from, to, location));
    }
    in.skip();
  }

  private static UnresolvedRoute.@Nullable End end(
      ElementCursor in, NameScope scope, String nodeAttribute, String fieldAttribute) {
    String node = in.attribute(nodeAttribute);
    String field = in.attribute(fieldAttribute);
    return node == null || field == null
        ? null
        : new UnresolvedRoute.End(node, field, scope.find(node));
  }

  /** Resolves the ROUTEs of a scope after all its nodes have been read. */
  void connect(NameScope scope) {
    for (UnresolvedRoute route : scope.routes()) {
      List<X3dFile.End> sources = ends(scope, route, route.from(), false);
      List<X3dFile.End> targets = sources == null ? null : ends(scope, route, route.to(), true);
      if (sources == null || targets == null) {
        continue;
      }
      for (X3dFile.End source : sources) {
        for (X3dFile.End target : targets) {
          connect(route, source, target);
        }
      }
    }
  }

  private void connect(UnresolvedRoute route, X3dFile.End source, X3dFile.End target) {
    if (!(source instanceof X3dFile.End.Own from) || !(target instanceof X3dFile.End.Own to)) {
      if (reading.spend(route.location())) {
        imported.add(new X3dFile.ImportedRoute(source, target, route.location()));
      }
      return;
    }
    FieldType sent = from.node().type().fields().get(from.field()).type();
    FieldType taken = to.node().type().fields().get(to.field()).type();
    if (sent != taken) {
      leaveOut(route, route.from() + " is " + sent + " and " + route.to() + " is " + taken);
    } else if (reading.spend(route.location())) {
      routes.add(new X3dFile.ParsedRoute(from.node(), from.field(), to.node(), to.field()));
    }
  }

  /** Returns the fields at an end of a ROUTE, or null after a message. */
  private @Nullable List<X3dFile.End> ends(
      NameScope scope, UnresolvedRoute route, UnresolvedRoute.End end, boolean input) {
    NameScope.Named named = end.found() != null ? end.found() : scope.find(end.node());
    if (named == null && scope.isLost(end.node())) {
      return null;
    }
    if (named == null) {
      if (scope.isImported(end.node())) {
        return List.of(new X3dFile.End.Imported(end.node(), end.field()));
      }
      leaveOut(
          route,
          "no node has the name "
              + end.node()
              + reading.question(end.node(), scope.names().keySet()));
      return null;
    }
    List<X3dFile.End> found = new ArrayList<>(1);
    if (resolve(named, end.field(), input, found)) {
      return found;
    }
    ProtoInstance instance = named.instance();
    if (instance == null || !instance.declaration().lacking().contains(end.field())) {
      leaveOut(route, why(named, end, input));
    }
    return null;
  }

  private String why(NameScope.Named named, UnresolvedRoute.End end, boolean input) {
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
   * Adds the fields to which a field name of a node resolves: one, or for an instance all those
   * that IS connects in its body. Returns false if there is no such field.
   */
  static boolean resolve(
      NameScope.Named named, String field, boolean input, List<? super X3dFile.End.Own> into) {
    ProtoInstance instance = named.instance();
    if (instance == null) {
      NodeType type = named.node().type();
      String now = LegacyFieldNames.now(type, field);
      FieldDefinition definition = (input ? type.input(now) : type.output(now)).orElse(null);
      if (definition != null) {
        into.add(new X3dFile.End.Own(named.node(), definition.index()));
      }
      return definition != null;
    }
    ProtoDeclaration.Field declared = instance.declaration().event(field, input);
    if (declared == null) {
      return false;
    }
    for (ProtoInstance.Connection connection : instance.connections(declared.name())) {
      // a connected field of the other direction only is not an error of the ROUTE
      resolve(connection.node(), connection.field(), input, into);
    }
    return true;
  }

  private void leaveOut(UnresolvedRoute route, String why) {
    reading.error(
        route.location(),
        why + "; the ROUTE " + route.from() + " to " + route.to() + " is left out");
  }
}
