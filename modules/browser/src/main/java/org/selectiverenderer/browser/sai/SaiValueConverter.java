package org.selectiverenderer.browser.sai;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;
import org.web3d.x3d.sai.InvalidFieldValueException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.X3DNode;

/**
 * Converts between the arguments of SAI methods and the values of {@link FieldType}. All values are
 * copied, so that no application writes into a field's array.
 */
final class SaiValueConverter {
  private final SaiContext binding;

  SaiValueConverter(SaiContext binding) {
    this.binding = binding;
  }

  /** Returns the number of elements in an MF value. */
  static int size(FieldType type, @Nullable Object value) {
    if (value == null) {
      return 0;
    }
    return type.isNode() ? ((List<?>) value).size() : Array.getLength(value) / type.components();
  }

  /** Returns a single value as SAI methods return it. */
  @Nullable Object result(FieldType type, @Nullable Object value) {
    return type.isNode() ? binding.wrap((Node) value) : value;
  }

  /**
   * Returns the value if the field accepts its node types.
   *
   * @throws InvalidNodeException if the field does not accept a node
   */
  static @Nullable Object accepted(FieldDefinition field, @Nullable Object value) {
    if (value instanceof Node node) {
      accept(field, node);
    } else if (field.type() == FieldType.MFNode && value instanceof List<?> nodes) {
      nodes.forEach(node -> accept(field, (Node) node));
    }
    return value;
  }

  private static void accept(FieldDefinition field, Node node) {
    if (!field.nodeTypes().isEmpty() && field.nodeTypes().stream().noneMatch(node.type()::is)) {
      throw new InvalidNodeException(
          "%s takes %s, not %s"
              .formatted(field.name(), String.join(" or ", field.nodeTypes()), node));
    }
  }

  /**
   * Converts a method's argument to the value of a whole field.
   *
   * @param argument scalar, array, array of tuples, node or array of nodes
   */
  @Nullable Object fromArgument(FieldType type, @Nullable Object argument) {
    if (type.isNode()) {
      return type.multiple() ? List.copyOf(nodes(argument)) : node(argument);
    }
    if (argument == null) {
      throw new InvalidFieldValueException("null is not a value of type " + type);
    }
    if (!type.multiple() && type.components() == 1) {
      return argument;
    }
    if (type == FieldType.SFImage) {
      return ImageFieldMethods.checked(((int[]) argument).clone());
    }
    Object flat = flat(type, argument);
    int given = Array.getLength(flat);
    if (!type.multiple()) {
      if (given < type.components()) {
        throw new InvalidFieldValueException(
            "%s needs %s components, not %s".formatted(type, type.components(), given));
      }
      return copy(flat, type.components());
    }
    if (given % type.components() != 0) {
      throw new InvalidFieldValueException(
          "%s numbers cannot be divided into values of %s".formatted(given, type));
    }
    return flat;
  }

  private @Nullable Node node(@Nullable Object argument) {
    if (argument == null || argument instanceof X3DNode) {
      return binding.unwrap((X3DNode) argument);
    }
    throw new InvalidNodeException("the object is not a node of this browser");
  }

  private List<Node> nodes(@Nullable Object argument) {
    List<Node> nodes = new ArrayList<>();
    if (argument instanceof X3DNode[] array) {
      for (X3DNode node : array) {
        Node unwrapped = binding.unwrap(node);
        if (unwrapped != null) {
          nodes.add(unwrapped);
        }
      }
    } else if (argument instanceof X3DNode node) {
      nodes.add(binding.unwrap(node));
    }
    return nodes;
  }

  /** Returns a new primitive or String array of the components in an argument. */
  private static Object flat(FieldType type, Object argument) {
    if (!argument.getClass().isArray()) {
      Object one = Array.newInstance(componentClass(type), 1);
      Array.set(one, 0, argument);
      return one;
    }
    int length = Array.getLength(argument);
    Class<?> element = argument.getClass().getComponentType();
    if (element.isArray()) {
      return flatRows(type, (Object[]) argument);
    }
    Object all = Array.newInstance(componentClass(type), length);
    if (element == long.class) {
      for (int i = 0; i < length; i++) {
        Array.setDouble(all, i, Array.getLong(argument, i) / 1000.0); // milliseconds
      }
      return all;
    }
    System.arraycopy(argument, 0, all, 0, length);
    if (all instanceof String[] strings && Arrays.asList(strings).contains(null)) {
      throw new InvalidFieldValueException("null is not a string");
    }
    return all;
  }

  private static Object flatRows(FieldType type, Object[] rows) {
    int width = type.components();
    Object all = Array.newInstance(componentClass(type), rows.length * width);
    for (int i = 0; i < rows.length; i++) {
      if (rows[i] == null || Array.getLength(rows[i]) < width) {
        throw new InvalidFieldValueException(
            "row %s is not a value of %s, which has %s components".formatted(i, type, width));
      }
      System.arraycopy(rows[i], 0, all, i * width, width);
    }
    return all;
  }

  private static Class<?> componentClass(FieldType type) {
    return switch (type.kind()) {
      case BOOLEAN -> boolean.class;
      case INT -> int.class;
      case FLOAT -> float.class;
      case DOUBLE -> double.class;
      case STRING -> String.class;
      case NODE -> Node.class;
    };
  }

  private static Object copy(Object array, int length) {
    Object copy = Array.newInstance(array.getClass().getComponentType(), length);
    System.arraycopy(array, 0, copy, 0, Math.min(length, Array.getLength(array)));
    return copy;
  }

  /** Copies a field's value into a caller's array. */
  void toArgument(FieldType type, Object value, Object target) {
    if (type.isNode()) {
      List<?> nodes = (List<?>) value;
      for (int i = 0; i < nodes.size(); i++) {
        Array.set(target, i, binding.wrap((Node) nodes.get(i)));
      }
    } else if (target.getClass().getComponentType().isArray()) {
      int width = type.components();
      for (int i = 0; i < Array.getLength(value) / width; i++) {
        System.arraycopy(value, i * width, Array.get(target, i), 0, width);
      }
    } else {
      System.arraycopy(value, 0, target, 0, Array.getLength(value));
    }
  }

  /** Returns one element of an MF field whose elements have one component. */
  @Nullable Object element(FieldType type, Object value, int index) {
    check(type, value, index, false);
    return type.isNode()
        ? binding.wrap((Node) ((List<?>) value).get(index))
        : Array.get(value, index);
  }

  /** Copies one element of an MF field into a caller's array. */
  void element(FieldType type, Object value, int index, Object target) {
    check(type, value, index, false);
    System.arraycopy(value, index * type.components(), target, 0, type.components());
  }

  /**
   * Converts a method's argument to one element of an MF field: an array of its components, or a
   * list of nodes.
   */
  Object tuple(FieldType type, @Nullable Object argument) {
    if (type.isNode()) {
      return nodes(argument);
    }
    if (argument == null) {
      throw new InvalidFieldValueException("null is not a value of type " + type);
    }
    Object tuple = flat(type, argument);
    if (Array.getLength(tuple) < type.components()) {
      throw new InvalidFieldValueException(
          "a value of %s has %s components, not %s"
              .formatted(type, type.components(), Array.getLength(tuple)));
    }
    return tuple;
  }

  /**
   * Returns an MF value in which an element made by {@link #tuple} is inserted or replaces another.
   */
  @SuppressWarnings("unchecked")
  Object splice(FieldType type, Object value, int at, int removed, Object tuple) {
    check(type, value, at, removed == 0);
    return type.isNode()
        ? spliced(value, at, removed, (List<Node>) tuple)
        : spliced(type, value, at, removed, tuple, type.components());
  }

  /** Returns an MF value without one of its elements. */
  Object without(FieldType type, Object value, int at) {
    check(type, value, at, false);
    return type.isNode()
        ? spliced(value, at, 1, List.of())
        : spliced(type, value, at, 1, Array.newInstance(componentClass(type), 0), 0);
  }

  private static Object spliced(Object value, int at, int removed, List<Node> inserted) {
    List<Node> nodes = new ArrayList<>();
    ((List<?>) value).forEach(node -> nodes.add((Node) node));
    nodes.subList(at, at + removed).clear();
    nodes.addAll(at, inserted);
    return List.copyOf(nodes);
  }

  private static Object spliced(
      FieldType type, Object value, int at, int removed, Object inserted, int more) {
    int width = type.components();
    int length = Array.getLength(value);
    Object result = Array.newInstance(componentClass(type), length - removed * width + more);
    System.arraycopy(value, 0, result, 0, at * width);
    System.arraycopy(inserted, 0, result, at * width, more);
    int rest = (at + removed) * width;
    System.arraycopy(value, rest, result, at * width + more, length - rest);
    return result;
  }

  private static void check(FieldType type, Object value, int index, boolean endAllowed) {
    int size = size(type, value);
    if (index < 0 || index > size || (index == size && !endAllowed)) {
      throw new ArrayIndexOutOfBoundsException("index %s of %s values".formatted(index, size));
    }
  }

  /** Returns the first elements of an argument as a whole field's value. */
  @Nullable Object first(FieldType type, int count, @Nullable Object argument) {
    if (argument == null) {
      throw new InvalidFieldValueException("null is not a value of type " + type);
    }
    if (argument instanceof X3DNode[] nodes) {
      checkAnnounced(type, count, nodes.length);
      return List.copyOf(nodes(Arrays.copyOf(nodes, count)));
    }
    Object all = flat(type, argument);
    checkAnnounced(type, count, Array.getLength(all) / type.components());
    return copy(all, count * type.components());
  }

  private static void checkAnnounced(FieldType type, int announced, int given) {
    if (announced < 0 || announced > given) {
      throw new InvalidFieldValueException(
          "%s values of %s are asked for, but only %s are given".formatted(announced, type, given));
    }
  }
}
