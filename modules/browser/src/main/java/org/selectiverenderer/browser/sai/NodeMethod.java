package org.selectiverenderer.browser.sai;

import java.lang.reflect.Method;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The operation that a method of a node interface stands for on nodes of one type, derived from the
 * method's name by the rule in the SAI's package description.
 *
 * @param field the field that is read or written; null where the method has none, or the type has
 *     none of that name
 * @param input for {@link Operation#WRITE}: the field that takes the value when {@code field} is
 *     not writable, such as set_bind
 * @param name the name of the field as the method has it, for messages
 */
record NodeMethod(
    Operation operation,
    @Nullable FieldDefinition field,
    @Nullable FieldDefinition input,
    String name) {
  /** The operation of a method. */
  enum Operation {
    EQUALS,
    HASH_CODE,
    TO_STRING,
    NODE_NAME,
    NODE_TYPE,
    DEFINITIONS,
    FIELD,
    REALIZE,
    IS_REALIZED,
    DISPOSE,
    /** The number of values of an MF field. */
    COUNT,
    /** The value is returned. */
    READ,
    /** The values are copied into the caller's array. */
    COPY,
    WRITE
  }

  static NodeMethod of(Method method, NodeType type) {
    String name = method.getName();
    return switch (name) {
      case "equals" -> plain(Operation.EQUALS);
      case "hashCode" -> plain(Operation.HASH_CODE);
      case "toString" -> plain(Operation.TO_STRING);
      case "getNodeName" -> plain(Operation.NODE_NAME);
      case "getNodeType", "getImplementationTypes" -> plain(Operation.NODE_TYPE);
      case "getFieldDefinitions" -> plain(Operation.DEFINITIONS);
      case "getField" -> plain(Operation.FIELD);
      case "realize" -> plain(Operation.REALIZE);
      case "isRealized" -> plain(Operation.IS_REALIZED);
      case "dispose" -> plain(Operation.DISPOSE);
      case "addChildren", "removeChildren" ->
          new NodeMethod(Operation.WRITE, type.field(name).orElse(null), null, name);
      default ->
          name.startsWith("set")
              ? setter(fieldName(name.substring(3)), type)
              : getter(name.substring(3), method.getParameterCount(), type);
    };
  }

  private static NodeMethod plain(Operation operation) {
    return new NodeMethod(operation, null, null, "");
  }

  private static NodeMethod setter(String x, NodeType type) {
    return new NodeMethod(
        Operation.WRITE, type.field(x).orElse(null), type.field("set_" + x).orElse(null), x);
  }

  private static NodeMethod getter(String name, int parameters, NodeType type) {
    if (name.startsWith("Num") && name.length() > 3 && parameters == 0) {
      String x = fieldName(name.substring(3));
      Optional<FieldDefinition> counted =
          readable(x, type).filter(field -> field.type().multiple());
      if (counted.isPresent()) {
        return new NodeMethod(Operation.COUNT, counted.get(), null, x);
      }
    }
    String x = fieldName(name);
    return new NodeMethod(
        parameters == 0 ? Operation.READ : Operation.COPY, readable(x, type).orElse(null), null, x);
  }

  private static Optional<FieldDefinition> readable(String x, NodeType type) {
    return type.field(x)
        .filter(field -> field.access() != AccessType.INPUT_ONLY)
        .or(() -> type.field(x + "_changed"));
  }

  private static String fieldName(String x) {
    return Character.toLowerCase(x.charAt(0)) + x.substring(1);
  }
}
