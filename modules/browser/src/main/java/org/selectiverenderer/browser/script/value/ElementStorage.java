package org.selectiverenderer.browser.script.value;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptRuntime;
import org.selectiverenderer.scriptengine.ScriptMeter;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The elements of an MF value, as {@link FieldType} represents them, in one array that grows. The
 * array is shared with the value that it was made of or that {@link #value} returned, until an
 * element is set: reading costs nothing, and of many changes the first alone copies.
 */
final class ElementStorage {
  /** The most elements, far more than scenes have. */
  static final int MAX_LENGTH = 1 << 24;

  /** The most bytes of room for elements to come. */
  private static final int MAX_ROOM = 1 << 26;

  private final FieldType type;
  private final FieldType element;

  /** Numbers of an element in the array. */
  private final int width;

  /** An array of primitives or strings; {@code Object[]} of nodes, and of images {@code int[]}. */
  private Object array;

  private int length;

  /** The present elements as a value of the field; null after a change. */
  private @Nullable Object value;

  /**
   * @param value the elements; not modified
   */
  ElementStorage(FieldType type, Object value) {
    this.type = type;
    element = single(type);
    width = Math.max(1, type.components());
    this.value = value;
    array =
        switch (type.kind()) {
          case NODE -> ((List<?>) value).toArray();
          case INT -> type == FieldType.MFImage ? images((int[]) value) : value;
          case BOOLEAN, FLOAT, DOUBLE, STRING -> value;
        };
    length = java.lang.reflect.Array.getLength(array) / width;
  }

  /** Stores elements given by their indices. */
  static ElementStorage of(FieldType type, int count, IntFunction<@Nullable Object> elements) {
    ElementStorage made = new ElementStorage(type, type.zero());
    made.resize(count);
    for (int i = 0; i < count; i++) {
      ScriptMeter.tick();
      made.set(i, elements.apply(i));
    }
    return made;
  }

  /** Returns the type of one element: SFVec3f for MFVec3f. */
  static FieldType single(FieldType type) {
    return FieldType.valueOf("S" + type.name().substring(1));
  }

  FieldType element() {
    return element;
  }

  int length() {
    return length;
  }

  /** Splits an MFImage into its images, each of which begins with its size. */
  private static Object[] images(int[] all) {
    List<int[]> images = new ArrayList<>();
    ScriptMeter.allocate(all.length, 4);
    for (int at = 0; at + 3 <= all.length; ) {
      ScriptMeter.tick();
      long size = 3 + (all[at + 2] == 0 ? 0 : (long) all[at] * all[at + 1]);
      int end = (int) Math.min(all.length, at + size);
      images.add(Arrays.copyOfRange(all, at, end));
      at = end;
    }
    return images.toArray();
  }

  /** Returns one element in the representation of the element type. */
  @Nullable Object at(int index) {
    Objects.checkIndex(index, length);
    int from = index * width;
    if (array instanceof float[] numbers) {
      return width == 1 ? numbers[index] : Arrays.copyOfRange(numbers, from, from + width);
    }
    if (array instanceof double[] numbers) {
      return width == 1 ? numbers[index] : Arrays.copyOfRange(numbers, from, from + width);
    }
    if (array instanceof int[] numbers) {
      return numbers[index];
    }
    return array instanceof boolean[] flags ? flags[index] : ((Object[]) array)[index];
  }

  /**
   * Sets one element.
   *
   * @param given in the representation of the element type
   */
  void set(int index, @Nullable Object given) {
    Objects.checkIndex(index, length);
    beforeChange();
    if (array instanceof float[] numbers) {
      if (given instanceof float[] tuple) {
        System.arraycopy(tuple, 0, numbers, index * width, width);
      } else {
        numbers[index] = (Float) Objects.requireNonNull(given);
      }
    } else if (array instanceof double[] numbers) {
      if (given instanceof double[] tuple) {
        System.arraycopy(tuple, 0, numbers, index * width, width);
      } else {
        numbers[index] = (Double) Objects.requireNonNull(given);
      }
    } else if (array instanceof int[] numbers) {
      numbers[index] = (Integer) Objects.requireNonNull(given);
    } else if (array instanceof boolean[] flags) {
      flags[index] = (Boolean) Objects.requireNonNull(given);
    } else {
      ((Object[]) array)[index] = given;
    }
  }

  /** Takes a copy of the array if others have it. */
  private void beforeChange() {
    if (value != null) {
      if (value == array) {
        array = copy(length);
      }
      value = null;
    }
  }

  private Object copy(int count) {
    ScriptMeter.allocate(count * width, bytes());
    int size = count * width;
    if (array instanceof float[] numbers) {
      return Arrays.copyOf(numbers, size);
    }
    if (array instanceof double[] numbers) {
      return Arrays.copyOf(numbers, size);
    }
    if (array instanceof int[] numbers) {
      return Arrays.copyOf(numbers, size);
    }
    return array instanceof boolean[] flags
        ? Arrays.copyOf(flags, size)
        : Arrays.copyOf((Object[]) array, size);
  }

  private int bytes() {
    return array instanceof float[] || array instanceof int[]
        ? 4
        : array instanceof boolean[] ? 1 : 8;
  }

  /**
   * Sets the number of elements; new ones have the default value.
   *
   * @throws org.mozilla.javascript.EcmaError if the number is out of range
   */
  void resize(double wanted) {
    if (!(wanted >= 0 && wanted <= MAX_LENGTH)) {
      throw ScriptRuntime.rangeError(
          "%s cannot have %s elements; the limit is %s"
              .formatted(type, ScriptRuntime.numberToString(wanted, 10), MAX_LENGTH));
    }
    int count = (int) wanted;
    if (count == length) {
      return;
    }
    if (count * width > java.lang.reflect.Array.getLength(array)) {
      int most = Math.max(count, Math.min(MAX_LENGTH, MAX_ROOM / (width * bytes())));
      array = copy(Math.max(count, Math.min(most, 2 * length)));
      value = null;
    } else {
      beforeChange();
    }
    if (count > length) {
      clear(length, Math.min(count, java.lang.reflect.Array.getLength(array) / width));
    }
    length = count;
  }

  /** Gives elements the default value. */
  private void clear(int from, int to) {
    ScriptMeter.work((to - from) >> 4);
    if (array instanceof float[] numbers) {
      Arrays.fill(numbers, from * width, to * width, 0);
      if (element == FieldType.SFRotation) {
        for (int i = from; i < to; i++) {
          numbers[i * width + 2] = 1;
        }
      }
    } else if (array instanceof double[] numbers) {
      Arrays.fill(numbers, from * width, to * width, 0);
    } else if (array instanceof int[] numbers) {
      Arrays.fill(numbers, from, to, 0);
    } else if (array instanceof boolean[] flags) {
      Arrays.fill(flags, from, to, false);
    } else {
      Arrays.fill((Object[]) array, from, to, element.zero());
    }
  }

  /** Returns the elements as a value of the field; NULL is left out of an MFNode. */
  Object value() {
    if (value == null) {
      if (type.isNode()) {
        value =
            List.copyOf(
                Arrays.asList((Object[]) array).subList(0, length).stream()
                    .filter(Objects::nonNull)
                    .toList());
      } else if (type == FieldType.MFImage) {
        value = joined();
      } else {
        if (java.lang.reflect.Array.getLength(array) != length * width) {
          array = copy(length);
        }
        value = array;
      }
    }
    return value;
  }

  private int[] joined() {
    long size = 0;
    for (int i = 0; i < length; i++) {
      ScriptMeter.tick();
      size += ((int[]) ((Object[]) array)[i]).length;
    }
    if (size > MAX_LENGTH) {
      throw ScriptRuntime.rangeError(
          "%s cannot have %s numbers; the limit is %s".formatted(type, size, MAX_LENGTH));
    }
    ScriptMeter.allocate((int) size, 4);
    int[] all = new int[(int) size];
    int at = 0;
    for (int i = 0; i < length; i++) {
      int[] image = (int[]) ((Object[]) array)[i];
      System.arraycopy(image, 0, all, at, image.length);
      at += image.length;
    }
    return all;
  }
}
