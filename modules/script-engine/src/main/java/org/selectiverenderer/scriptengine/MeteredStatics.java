package org.selectiverenderer.scriptengine;

import static org.selectiverenderer.scriptengine.ScriptMeter.allocate;
import static org.selectiverenderer.scriptengine.ScriptMeter.allocateCharacters;
import static org.selectiverenderer.scriptengine.ScriptMeter.allocateReferences;
import static org.selectiverenderer.scriptengine.ScriptMeter.bulk;
import static org.selectiverenderer.scriptengine.ScriptMeter.work;

import java.text.Normalizer;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Static methods of the JDK with their work metered. The build lets Rhino call these instead of the
 * methods of the same name and parameters.
 */
public final class MeteredStatics {
  private MeteredStatics() {}

  public static boolean equals(@Nullable Object one, @Nullable Object other) {
    if (one instanceof String text) {
      bulk(text.length());
    }
    return Objects.equals(one, other);
  }

  public static void arraycopy(Object from, int at, Object to, int into, int length) {
    bulk(length);
    System.arraycopy(from, at, to, into, length);
  }

  public static void fill(char[] array, char value) {
    bulk(array.length);
    Arrays.fill(array, value);
  }

  public static void fill(@Nullable Object[] array, @Nullable Object value) {
    bulk(array.length);
    Arrays.fill(array, value);
  }

  public static void fill(@Nullable Object[] array, int from, int to, @Nullable Object value) {
    bulk(to - from);
    Arrays.fill(array, from, to, value);
  }

  public static byte[] copyOf(byte[] array, int length) {
    allocate(length, 1);
    return Arrays.copyOf(array, length);
  }

  public static double[] copyOf(double[] array, int length) {
    allocate(length, 8);
    return Arrays.copyOf(array, length);
  }

  public static int[] copyOf(int[] array, int length) {
    allocate(length, 4);
    return Arrays.copyOf(array, length);
  }

  public static @Nullable Object[] copyOf(@Nullable Object[] array, int length) {
    allocateReferences(length);
    return Arrays.copyOf(array, length);
  }

  public static @Nullable Object[] copyOfRange(@Nullable Object[] array, int from, int to) {
    allocateReferences(to - from);
    return Arrays.copyOfRange(array, from, to);
  }

  public static void sort(Object[] array) {
    sorted(array);
    Arrays.sort(array);
  }

  public static void sort(Object[] array, @Nullable Comparator<Object> order) {
    sorted(array);
    Arrays.sort(array, order);
  }

  private static void sorted(Object[] array) {
    work(array.length);
    allocateReferences(array.length / 2);
  }

  public static String valueOf(char[] text) {
    allocateCharacters(text.length);
    return String.valueOf(text);
  }

  public static String valueOf(char[] text, int from, int count) {
    allocateCharacters(count);
    return String.valueOf(text, from, count);
  }

  public static double parseDouble(String text) {
    work(text.length() >> 2);
    allocateCharacters(text.length());
    return Double.parseDouble(text);
  }

  public static String normalize(CharSequence text, Normalizer.Form form) {
    return TextParts.change(text.toString(), part -> Normalizer.normalize(part, form));
  }
}
