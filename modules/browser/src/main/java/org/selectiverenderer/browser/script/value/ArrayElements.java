package org.selectiverenderer.browser.script.value;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.scriptengine.ScriptMeter;
import org.selectiverenderer.x3d.field.FieldType;

/** Accesses the elements of MF values as {@link FieldType} represents them. */
final class ArrayElements {
  private ArrayElements() {}

  /** Returns the type of one element: SFVec3f for MFVec3f. */
  static FieldType single(FieldType type) {
    return FieldType.valueOf("S" + type.name().substring(1));
  }

  static int count(FieldType type, Object value) {
    return switch (type.kind()) {
      case NODE -> ((List<?>) value).size();
      case STRING -> ((String[]) value).length;
      case BOOLEAN -> ((boolean[]) value).length;
      case INT -> type == FieldType.MFImage ? images((int[]) value).size() : ((int[]) value).length;
      case FLOAT -> ((float[]) value).length / type.components();
      case DOUBLE -> ((double[]) value).length / type.components();
    };
  }

  /** Returns one element in the representation of the element type. */
  static @Nullable Object at(FieldType type, Object value, int index) {
    int from = index * type.components();
    int to = from + type.components();
    boolean tuple = type.components() > 1;
    return switch (type.kind()) {
      case NODE -> ((List<?>) value).get(index);
      case STRING -> ((String[]) value)[index];
      case BOOLEAN -> ((boolean[]) value)[index];
      case INT ->
          type == FieldType.MFImage ? images((int[]) value).get(index) : ((int[]) value)[index];
      case FLOAT ->
          tuple ? Arrays.copyOfRange((float[]) value, from, to) : ((float[]) value)[index];
      case DOUBLE ->
          tuple ? Arrays.copyOfRange((double[]) value, from, to) : ((double[]) value)[index];
    };
  }

  /** Splits an MFImage into its images, each of which begins with its size. */
  private static List<int[]> images(int[] all) {
    List<int[]> images = new ArrayList<>();
    for (int at = 0; at + 3 <= all.length; ) {
      ScriptMeter.tick();
      long size = 3 + (all[at + 2] == 0 ? 0 : (long) all[at] * all[at + 1]);
      int end = (int) Math.min(all.length, at + size);
      images.add(Arrays.copyOfRange(all, at, end));
      at = end;
    }
    return images;
  }

  /** Builds an MF value from its elements; NULL is left out of an MFNode. */
  static Object gather(FieldType type, int count, IntFunction<@Nullable Object> elements) {
    int width = type.components();
    ScriptMeter.allocate(count * width, 4);
    IntFunction<@Nullable Object> element =
        i -> {
          ScriptMeter.tick();
          return elements.apply(i);
        };
    return switch (type.kind()) {
      case NODE -> {
        List<Object> nodes = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
          Object node = element.apply(i);
          if (node != null) {
            nodes.add(node);
          }
        }
        yield List.copyOf(nodes);
      }
      case STRING -> {
        String[] strings = new String[count];
        Arrays.setAll(strings, i -> (String) element.apply(i));
        yield strings;
      }
      case BOOLEAN -> {
        boolean[] flags = new boolean[count];
        for (int i = 0; i < count; i++) {
          flags[i] = (Boolean) element.apply(i);
        }
        yield flags;
      }
      case INT -> ints(type, count, element);
      case FLOAT -> {
        float[] numbers = new float[count * width];
        for (int i = 0; i < count; i++) {
          Object one = element.apply(i);
          if (width == 1) {
            numbers[i] = (Float) one;
          } else {
            System.arraycopy((float[]) one, 0, numbers, i * width, width);
          }
        }
        yield numbers;
      }
      case DOUBLE -> {
        double[] numbers = new double[count * width];
        for (int i = 0; i < count; i++) {
          Object one = element.apply(i);
          if (width == 1) {
            numbers[i] = (Double) one;
          } else {
            System.arraycopy((double[]) one, 0, numbers, i * width, width);
          }
        }
        yield numbers;
      }
    };
  }

  private static int[] ints(FieldType type, int count, IntFunction<@Nullable Object> element) {
    if (type != FieldType.MFImage) {
      int[] numbers = new int[count];
      Arrays.setAll(numbers, i -> (Integer) element.apply(i));
      return numbers;
    }
    int length = 0;
    List<int[]> images = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int[] image = (int[]) element.apply(i);
      length = Math.addExact(length, image.length);
      images.add(image);
    }
    ScriptMeter.allocate(length, 4);
    int[] all = new int[length];
    int at = 0;
    for (int[] image : images) {
      System.arraycopy(image, 0, all, at, image.length);
      at += image.length;
    }
    return all;
  }
}
