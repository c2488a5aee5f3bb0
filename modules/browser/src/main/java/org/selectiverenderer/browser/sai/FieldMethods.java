package org.selectiverenderer.browser.sai;

import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * Implements the methods of the SAI's field interfaces that read and write values: getValue,
 * append, set1Value ...
 */
final class FieldMethods {
  private FieldMethods() {}

  /** The field whose methods are called. */
  interface Target {
    /** Returns its value; throws if the field is not readable. */
    @Nullable Object value();

    /**
     * Replaces the value by a function of the value at the time of the change, so that another
     * thread's write in between is not lost.
     */
    void change(UnaryOperator<@Nullable Object> change);
  }

  /**
   * Executes a method.
   *
   * @return the method's result
   */
  static @Nullable Object call(
      String method, FieldType type, Object[] a, Target field, SaiValueConverter values) {
    switch (method) {
      case "getSize" -> {
        return SaiValueConverter.size(type, field.value());
      }
      case "getValue" -> {
        if (a.length == 0) {
          return values.result(type, field.value());
        }
        values.toArgument(type, field.value(), a[0]);
      }
      case "get1Value" -> {
        if (a.length == 1) {
          return values.element(type, field.value(), (Integer) a[0]);
        }
        values.element(type, field.value(), (Integer) a[0], a[1]);
      }
      case "setValue" -> {
        Object value = newValue(type, a, values);
        field.change(old -> value);
      }
      case "clear" -> field.change(old -> type.zero());
      case "append" -> {
        Object tuple = values.tuple(type, a[0]);
        field.change(old -> values.splice(type, old, SaiValueConverter.size(type, old), 0, tuple));
      }
      case "insertValue" -> {
        Object tuple = values.tuple(type, a[1]);
        field.change(old -> values.splice(type, old, (Integer) a[0], 0, tuple));
      }
      case "removeValue" -> field.change(old -> values.without(type, old, (Integer) a[0]));
      case "set1Value" -> {
        Object tuple = values.tuple(type, a[1]);
        field.change(old -> values.splice(type, old, (Integer) a[0], 1, tuple));
      }
      default -> {
        return ImageFieldMethods.call(method, a, field);
      }
    }
    return null;
  }

  private static @Nullable Object newValue(FieldType type, Object[] a, SaiValueConverter values) {
    if (type == FieldType.SFImage) {
      return ImageFieldMethods.of((Integer) a[0], (Integer) a[1], (Integer) a[2], (int[]) a[3]);
    }
    return a.length == 1
        ? values.fromArgument(type, a[0])
        : values.first(type, (Integer) a[0], a[1]);
  }
}
