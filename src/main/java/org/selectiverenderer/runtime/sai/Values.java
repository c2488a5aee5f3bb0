package org.selectiverenderer.runtime.sai;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.FieldType;
import org.web3d.x3d.sai.InvalidFieldValueException;
import org.web3d.x3d.sai.X3DNode;

/**
 * Between the arguments of SAI methods and the values of {@link FieldType}. What is handed in or
 * out is copied, so that nobody outside writes into a field's array.
 */
final class Values {
  private final EmbeddedBrowser browser;

  Values(EmbeddedBrowser browser) {
    this.browser = browser;
  }

  /** The number of tuples in an MF value. */
  static int size(FieldType type, Object value) {
    return type.isNode() ? ((List<?>) value).size() : Array.getLength(value) / type.components();
  }

  /**
   * The value of a whole field from a method's argument.
   *
   * @param argument scalar, array, array of tuples, node or array of nodes
   */
  @Nullable Object fromArgument(FieldType type, @Nullable Object argument) {
    if (type.isNode()) {
      return type.multiple() ? List.copyOf(nodes(argument)) : browser.unwrap((X3DNode) argument);
    }
    if (argument == null) {
      throw new InvalidFieldValueException("null is no value of type " + type);
    }
    if (!type.multiple() && type.components() == 1) {
      return argument;
    }
    Object flat = flat(type, argument);
    if (!type.multiple() && type.components() > 1) {
      int given = Array.getLength(flat);
      if (given < type.components()) {
        throw new InvalidFieldValueException(
            "%s needs %s components, not %s".formatted(type, type.components(), given));
      }
      return copy(flat, type.components());
    }
    return flat;
  }

  private List<Node> nodes(@Nullable Object argument) {
    List<Node> nodes = new ArrayList<>();
    if (argument instanceof X3DNode[] array) {
      for (X3DNode node : array) {
        Node unwrapped = browser.unwrap(node);
        if (unwrapped != null) {
          nodes.add(unwrapped);
        }
      }
    } else if (argument instanceof X3DNode node) {
      nodes.add(browser.unwrap(node));
    }
    return nodes;
  }

  /** A fresh primitive or String array of the components in an argument. */
  private static Object flat(FieldType type, Object argument) {
    if (!argument.getClass().isArray()) {
      Object one = Array.newInstance(componentClass(type), 1);
      Array.set(one, 0, argument);
      return one;
    }
    int length = Array.getLength(argument);
    Class<?> element = argument.getClass().getComponentType();
    if (element.isArray()) {
      int width = type.components();
      Object all = Array.newInstance(componentClass(type), length * width);
      for (int i = 0; i < length; i++) {
        System.arraycopy(Array.get(argument, i), 0, all, i * width, width);
      }
      return all;
    }
    Object all = Array.newInstance(componentClass(type), length);
    if (element == componentClass(type)) {
      System.arraycopy(argument, 0, all, 0, length);
    } else {
      for (int i = 0; i < length; i++) {
        Array.set(all, i, Array.get(argument, i));
      }
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

  /** Writes a field's value into the beginning of a caller's array. */
  void toArgument(FieldType type, Object value, Object target) {
    if (type.isNode()) {
      List<?> nodes = (List<?>) value;
      for (int i = 0; i < nodes.size(); i++) {
        Array.set(target, i, browser.wrap((Node) nodes.get(i)));
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

  /** One value of an MF field that is no tuple. */
  @Nullable Object element(FieldType type, Object value, int index) {
    check(type, value, index, false);
    return type.isNode()
        ? browser.wrap((Node) ((List<?>) value).get(index))
        : Array.get(value, index);
  }

  /** Writes one tuple of an MF field into the beginning of a caller's array. */
  void element(FieldType type, Object value, int index, Object target) {
    check(type, value, index, false);
    System.arraycopy(value, index * type.components(), target, 0, type.components());
  }

  /** An MF value with some tuples replaced by others. */
  Object splice(FieldType type, Object value, int at, int removed, @Nullable Object argument) {
    check(type, value, at, removed == 0);
    if (type.isNode()) {
      List<Node> nodes = new ArrayList<>();
      ((List<?>) value).forEach(node -> nodes.add((Node) node));
      nodes.subList(at, at + removed).clear();
      nodes.addAll(at, argument == null ? List.of() : nodes(argument));
      return List.copyOf(nodes);
    }
    int width = type.components();
    Object inserted =
        argument == null ? Array.newInstance(componentClass(type), 0) : flat(type, argument);
    int more = argument == null ? 0 : width;
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

  /** The first tuples of an argument, as a whole field's value. */
  @Nullable Object first(FieldType type, int count, Object argument) {
    Object all = fromArgument(type, argument);
    if (all instanceof List<?> list) {
      return List.copyOf(list.subList(0, Math.min(count, list.size())));
    }
    if (all == null || Array.getLength(all) < count * type.components()) {
      throw new InvalidFieldValueException(
          "%s values of %s are announced, fewer are given".formatted(count, type));
    }
    return copy(all, count * type.components());
  }
}
