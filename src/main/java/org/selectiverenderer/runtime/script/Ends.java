package org.selectiverenderer.runtime.script;

import org.mozilla.javascript.ScriptRuntime;
import org.selectiverenderer.runtime.scene.InstanceFace;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Route;
import org.selectiverenderer.runtime.script.value.NodeValue;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** What scripts want to connect (X3D 4.0, 4.4.8.2). */
final class Ends {
  private Ends() {}

  /** The same as a node of the scene: of an instance, the first of its body. */
  static Node body(Object argument) {
    return InstanceFace.body(node(argument));
  }

  /** A node among the arguments of a method. */
  static Node node(Object argument) {
    if (argument instanceof NodeValue value) {
      return value.node();
    }
    throw ScriptRuntime.typeError("a node is needed here");
  }

  /** The route that {@code (fromNode, fromField, toNode, toField)} describe. */
  static Route route(Object[] args) {
    Node from = node(args[0]);
    Node to = node(args[2]);
    String out = HostObject.text(args[1]);
    String in = HostObject.text(args[3]);
    FieldDefinition source =
        from.type().output(out).orElseThrow(() -> wrong(from, " sends no " + out));
    FieldDefinition target = to.type().input(in).orElseThrow(() -> wrong(to, " receives no " + in));
    if (source.type() != target.type()) {
      throw ScriptRuntime.typeError(
          "%s is %s and %s is %s; they cannot be connected"
              .formatted(out, source.type(), in, target.type()));
    }
    return new Route(from, source.index(), to, target.index());
  }

  private static RuntimeException wrong(Node node, String what) {
    return ScriptRuntime.typeError(node.type().name() + what);
  }
}
