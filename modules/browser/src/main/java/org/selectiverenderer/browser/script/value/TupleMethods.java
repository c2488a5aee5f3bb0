package org.selectiverenderer.browser.script.value;

import java.util.function.DoubleBinaryOperator;
import org.mozilla.javascript.LambdaConstructor;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.x3d.field.FieldType;

/** The methods of vectors, colours, rotations and matrices (ISO/IEC 19777-1, 7.3). */
final class TupleMethods {
  /** The body of a method, given its object and at least the required arguments. */
  @FunctionalInterface
  private interface Body {
    Object call(TupleValue self, Object[] args);
  }

  private final Scriptable scope;
  private final FieldValueConverter values;
  private final FieldType type;

  TupleMethods(Scriptable scope, FieldValueConverter values, FieldType type) {
    this.scope = scope;
    this.values = values;
    this.type = type;
  }

  void define(LambdaConstructor into) {
    switch (type) {
      case SFColor, SFColorRGBA -> colour(into);
      case SFRotation -> rotation(into);
      case SFMatrix3f, SFMatrix3d, SFMatrix4f, SFMatrix4d -> matrix(into);
      default -> vector(into);
    }
  }

  private void method(LambdaConstructor into, String name, int count, Body body) {
    into.definePrototypeMethod(
        scope,
        name,
        count,
        (cx, from, self, args) -> {
          if (!(self instanceof TupleValue tuple)) {
            throw ScriptRuntime.typeError(name + " is a method of " + type);
          }
          if (args.length < count) {
            throw ScriptRuntime.typeError(
                "%s of %s needs %s arguments, not %s".formatted(name, type, count, args.length));
          }
          return body.call(tuple, args);
        });
  }

  private TupleValue same(double... components) {
    return values.tuple(type, components);
  }

  private static double[] of(Object argument) {
    return FieldConstructors.tuple(argument).components();
  }

  private static double number(Object argument) {
    return ScriptRuntime.toNumber(argument);
  }

  private static double[] each(double[] a, double[] b, DoubleBinaryOperator operator) {
    double[] result = new double[a.length];
    for (int i = 0; i < result.length; i++) {
      result[i] = operator.applyAsDouble(a[i], i < b.length ? b[i] : 0);
    }
    return result;
  }

  private static double[] scaled(double[] a, double factor) {
    return each(a, a, (x, y) -> x * factor);
  }

  private void vector(LambdaConstructor into) {
    method(into, "add", 1, (self, a) -> same(each(self.components(), of(a[0]), Double::sum)));
    method(
        into, "subtract", 1, (self, a) -> same(each(self.components(), of(a[0]), (x, y) -> x - y)));
    method(into, "multiply", 1, (self, a) -> multiplied(self, a[0]));
    method(into, "scale", 1, (self, a) -> multiplied(self, a[0]));
    method(into, "divide", 1, (self, a) -> same(divided(self.components(), number(a[0]))));
    method(into, "negate", 0, (self, a) -> same(scaled(self.components(), -1)));
    method(into, "length", 0, (self, a) -> VectorMath.length(self.components()));
    method(into, "normalize", 0, (self, a) -> same(VectorMath.normalized(self.components())));
    method(into, "dot", 1, (self, a) -> VectorMath.dot(self.components(), of(a[0])));
    method(
        into,
        "distance",
        1,
        (self, a) -> VectorMath.length(each(self.components(), of(a[0]), (x, y) -> x - y)));
    method(into, "lerp", 2, (self, a) -> same(blend(self, of(a[0]), number(a[1]))));
    if (type.components() == 3) {
      method(into, "cross", 1, (self, a) -> same(VectorMath.cross(self.components(), of(a[0]))));
    }
  }

  private static double[] divided(double[] a, double divisor) {
    return each(a, a, (x, y) -> x / divisor);
  }

  private static double[] blend(TupleValue self, double[] to, double t) {
    return each(self.components(), to, (x, y) -> x + (y - x) * t);
  }

  /** Multiplies by a number, or component-wise by another vector. */
  private TupleValue multiplied(TupleValue self, Object by) {
    return by instanceof TupleValue other
        ? same(each(self.components(), other.components(), (x, y) -> x * y))
        : same(scaled(self.components(), number(by)));
  }

  private void colour(LambdaConstructor into) {
    method(
        into,
        "setHSV",
        3,
        (self, a) -> {
          double[] rgb = VectorMath.rgb(number(a[0]), number(a[1]), number(a[2]));
          double alpha = a.length > 3 ? number(a[3]) : type == FieldType.SFColor ? 1 : self.at(3);
          self.set(type == FieldType.SFColor ? rgb : VectorMath.append(rgb, alpha));
          return Undefined.instance;
        });
    method(
        into,
        "getHSV",
        0,
        (self, a) -> {
          double[] hsv = VectorMath.hsv(self.at(0), self.at(1), self.at(2));
          Object[] list = {hsv[0], hsv[1], hsv[2]};
          return org.mozilla.javascript.Context.getCurrentContext().newArray(scope, list);
        });
    method(into, "lerp", 2, (self, a) -> same(blend(self, of(a[0]), number(a[1]))));
  }

  private void rotation(LambdaConstructor into) {
    method(
        into,
        "getAxis",
        0,
        (self, a) -> values.tuple(FieldType.SFVec3f, self.at(0), self.at(1), self.at(2)));
    method(
        into,
        "setAxis",
        1,
        (self, a) -> {
          double[] axis = of(a[0]);
          self.set(axis[0], axis[1], axis[2], self.at(3));
          return Undefined.instance;
        });
    method(into, "inverse", 0, (self, a) -> same(VectorMath.inverse(self.components())));
    method(into, "multiply", 1, (self, a) -> same(VectorMath.product(self.components(), of(a[0]))));
    method(
        into,
        "multVec",
        1,
        (self, a) ->
            values.tuple(
                FieldConstructors.tuple(a[0]).type(),
                VectorMath.turned(self.components(), of(a[0]))));
    method(
        into,
        "slerp",
        2,
        (self, a) -> same(VectorMath.slerp(self.components(), of(a[0]), number(a[1]))));
  }

  private void matrix(LambdaConstructor into) {
    MatrixMethods matrices = new MatrixMethods(type);
    method(into, "inverse", 0, (self, a) -> same(matrices.inverse(self.components())));
    method(into, "transpose", 0, (self, a) -> same(matrices.transpose(self.components())));
    method(into, "determinant", 0, (self, a) -> matrices.determinant(self.components()));
    method(into, "multLeft", 1, (self, a) -> same(matrices.product(of(a[0]), self.components())));
    method(into, "multRight", 1, (self, a) -> same(matrices.product(self.components(), of(a[0]))));
    method(
        into,
        "multVecMatrix",
        1,
        (self, a) -> moved(a[0], matrices.rowTimes(of(a[0]), self.components())));
    method(
        into,
        "multMatrixVec",
        1,
        (self, a) ->
            moved(a[0], matrices.rowTimes(of(a[0]), matrices.transpose(self.components()))));
    method(
        into,
        "setTransform",
        0,
        (self, a) -> {
          self.set(matrices.transform(a));
          return Undefined.instance;
        });
    method(
        into,
        "getTransform",
        0,
        (self, a) -> {
          matrices.taken(self.components(), a);
          return Undefined.instance;
        });
  }

  private TupleValue moved(Object vector, double[] components) {
    return values.tuple(FieldConstructors.tuple(vector).type(), components);
  }
}
