package org.selectiverenderer.browser.script;

import org.mozilla.javascript.ScriptRuntime;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.scene.Route;
import org.selectiverenderer.browser.script.value.NodeValue;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** Reads the endpoints of routes from the arguments of script methods (X3D 4.0, 4.4.8.2). */
final class RouteEndpoints {
  private RouteEndpoints() {}

  /**
   * Returns the scene's node of an argument: for a prototype instance, the first node of its body.
   */
  static Node body(Object argument) {
    return PrototypeInstance.body(node(argument));
  }

  /** Returns the node of an argument. */
  static Node node(Object argument) {
    if (argument instanceof NodeValue value) {
      return value.node();
    }
    throw ScriptRuntime.typeError("an argument must be a node (SFNode)");
  }

  /**
   * Returns the route that the arguments {@code (fromNode, fromField, toNode, toField)} describe.
   */
  static Route route(Object[] args) {
    Node from = node(args[0]);
    Node to = node(args[2]);
    String out = HostObject.text(args[1]);
    String in = HostObject.text(args[3]);
    FieldDefinition source =
        from.type().output(out).orElseThrow(() -> wrong(from, " has no output field " + out));
    FieldDefinition target =
        to.type().input(in).orElseThrow(() -> wrong(to, " has no input field " + in));
    if (source.type() != target.type()) {
      throw ScriptRuntime.typeError(
          "%s (%s) cannot be routed to %s (%s): the types differ"
              .formatted(out, source.type(), in, target.type()));
    }
    return new Route(from, source.index(), to, target.index());
  }

  private static RuntimeException wrong(Node node, String what) {
    return ScriptRuntime.typeError(node.type().name() + what);
  }
}
