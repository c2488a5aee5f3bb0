package org.selectiverenderer.browser.script;

import org.mozilla.javascript.Scriptable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Route;

/** The {@code X3DRoute} object of scripts. */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
final class RouteObject extends HostObject {
  private final transient Route route;

  RouteObject(Route route, RhinoEngine engine, Scriptable scope) {
    super("X3DRoute", scope);
    this.route = route;
    property("sourceNode", () -> engine.values().exactly(route.from()));
    property("sourceField", () -> name(route.from(), route.fromField()));
    property("destinationNode", () -> engine.values().exactly(route.to()));
    property("destinationField", () -> name(route.to(), route.toField()));
  }

  private static String name(Node node, int field) {
    return node.type().fields().get(field).name();
  }

  Route route() {
    return route;
  }
}
