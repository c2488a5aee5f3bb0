package org.selectiverenderer.browser.script;

import java.util.function.Function;
import java.util.function.Supplier;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.LambdaConstructor;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.browser.script.value.NodeValue;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** The methods of SFNode objects (ISO/IEC 19777-1, 7.3). */
final class NodeObjectMethods {
  private NodeObjectMethods() {}

  /**
   * Adds the methods to the constructor SFNode of a scope.
   *
   * @param complete called before a node is written as text
   */
  static void define(ScriptableObject scope, Supplier<NodeCatalogue> catalogue, Runnable complete) {
    LambdaConstructor into = (LambdaConstructor) ScriptableObject.getProperty(scope, "SFNode");
    method(scope, into, "getNodeTypeName", node -> node.node().type().name());
    method(
        scope,
        into,
        "getNodeName",
        node -> {
          String name = node.node().name();
          return name == null ? "" : name;
        });
    method(scope, into, "getFieldDefinitions", node -> definitions(node, scope));
    method(
        scope,
        into,
        "toXMLString",
        node -> {
          complete.run();
          return NodeSerializer.xml(node.node());
        });
    method(
        scope,
        into,
        "toVRMLString",
        node -> {
          complete.run();
          return NodeSerializer.classic(node.node(), catalogue.get());
        });
  }

  private static void method(
      ScriptableObject scope,
      LambdaConstructor into,
      String name,
      Function<NodeValue, Object> body) {
    into.definePrototypeMethod(
        scope,
        name,
        0,
        (cx, from, self, args) -> {
          if (self instanceof NodeValue node) {
            return body.apply(node);
          }
          throw ScriptRuntime.typeError(name + " is a method of SFNode");
        });
  }

  private static Scriptable definitions(NodeValue node, ScriptableObject scope) {
    Context context = Context.getCurrentContext();
    Object[] all =
        node.node().type().fields().stream()
            .map(field -> definition(field, context.newObject(scope)))
            .toArray();
    return context.newArray(scope, all);
  }

  private static Scriptable definition(FieldDefinition field, Scriptable definition) {
    definition.put("name", definition, field.name());
    definition.put("accessType", definition, X3dConstants.of(field.access()));
    definition.put("dataType", definition, X3dConstants.of(field.type()));
    return definition;
  }
}
