package org.selectiverenderer.browser.script.value;

import org.mozilla.javascript.Context;
import org.mozilla.javascript.LambdaConstructor;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.SerializableCallable;
import org.mozilla.javascript.SymbolKey;

/**
 * The methods that all values have: {@code toString}, {@code getTypeName}, {@code equals} and
 * conversion to a primitive.
 */
final class CommonValueMethods {
  private CommonValueMethods() {}

  static void define(Scriptable scope, LambdaConstructor constructor) {
    SerializableCallable text = (cx, from, self, args) -> text(self);
    constructor.definePrototypeMethod(scope, "toString", 0, text);
    constructor.definePrototypeMethod(
        scope, "getTypeName", 0, (cx, from, self, args) -> typeName(self));
    constructor.definePrototypeMethod(
        scope, "equals", 1, (cx, from, self, args) -> equal(self, args));
    constructor.definePrototypeMethod(
        scope, SymbolKey.TO_PRIMITIVE, 1, (cx, from, self, args) -> text(self));
  }

  private static Object text(Object self) {
    if (self instanceof FieldValue value) {
      return value.text();
    }
    return self instanceof NodeValue node ? node.getDefaultValue(null) : Context.toString(self);
  }

  /** Returns {@code getTypeName}: for a node its node type, for other values their field type. */
  private static Object typeName(Object self) {
    return self instanceof NodeValue node
        ? node.node().type().name()
        : ((Scriptable) self).getClassName();
  }

  private static boolean equal(Object self, Object[] args) {
    if (args.length == 0) {
      return false;
    }
    if (self instanceof NodeValue node && args[0] instanceof NodeValue other) {
      return node.node() == other.node();
    }
    if (self instanceof TupleValue tuple && args[0] instanceof TupleValue other) {
      return tuple.same(other);
    }
    return self instanceof FieldValue value
        && args[0] instanceof FieldValue other
        && value.type() == other.type()
        && value.text().equals(other.text());
  }
}
