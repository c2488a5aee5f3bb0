package org.selectiverenderer.x3d.field;

import java.lang.invoke.VarHandle;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Holds a large array of a field in less memory until somebody reads it: what a mesh has been made
 * of is seldom read again. Indices are kept as differences from those a few places before, which
 * mostly fit into a byte; floats of few decimals are kept as 16-bit multiples of a power of ten.
 * Thread-safe.
 */
public final class PackedArray {
  /** The length below which an array is not packed. */
  private static final int LEAST = 2048;

  /** The distances at which indices of triangles and quads, separated by -1 or not, repeat. */
  private static final int[] LAGS = {1, 3, 4, 5};

  /** The number of indices by which the distance is chosen. */
  private static final int SAMPLE = 1024;

  private static final float[] TENS = {1, 10, 100, 1000, 10_000};

  /** The short that stands for minus zero. */
  private static final short MINUS_ZERO = Short.MIN_VALUE;

  /** Unpacks what it holds. */
  @FunctionalInterface
  private interface Form {
    Object array();
  }

  private @Nullable Form form;
  private @Nullable Object array;

  private PackedArray(Form form) {
    this.form = form;
    // Other threads may come upon it through a node at any time and must not see it without a form.
    VarHandle.releaseFence();
  }

  /**
   * Packs an array, which must not change afterwards.
   *
   * @return the value itself if it is no large array or would need more than half of the memory
   */
  public static Object of(Object value) {
    Form form = null;
    if (value instanceof int[] ints && ints.length >= LEAST) {
      form = packed(ints);
    } else if (value instanceof float[] floats && floats.length >= LEAST) {
      form = packed(floats);
    }
    return form == null ? value : new PackedArray(form);
  }

  /** Returns a value of which {@link #of} made what is given. */
  public static @Nullable Object read(@Nullable Object kept) {
    return kept instanceof PackedArray packed ? packed.array() : kept;
  }

  /** Returns the array, which replaces the packed form. */
  private synchronized Object array() {
    Object known = array;
    if (known == null && form != null) {
      known = form.array();
      array = known;
      form = null;
    }
    if (known == null) {
      throw new IllegalStateException("neither packed nor read");
    }
    return known;
  }

  private static @Nullable Form packed(int[] values) {
    int lag = lag(values);
    byte[] bytes = new byte[2 * values.length];
    int length = 0;
    for (int i = 0; i < values.length; i++) {
      int rest = difference(values, i, lag);
      while ((rest & ~0x7f) != 0) {
        if (length + 2 > bytes.length) {
          return null;
        }
        bytes[length++] = (byte) (rest | 0x80);
        rest >>>= 7;
      }
      if (length == bytes.length) {
        return null;
      }
      bytes[length++] = (byte) rest;
    }
    byte[] exact = Arrays.copyOf(bytes, length);
    int count = values.length;
    return () -> unpacked(exact, count, lag);
  }

  /** Returns the distance with the smallest differences at the start of the values. */
  private static int lag(int[] values) {
    int best = LAGS[0];
    long least = Long.MAX_VALUE;
    for (int lag : LAGS) {
      long sum = 0;
      for (int i = lag; i < Math.min(SAMPLE, values.length); i++) {
        sum += 32 - Integer.numberOfLeadingZeros(difference(values, i, lag) >>> 7);
      }
      if (sum < least) {
        least = sum;
        best = lag;
      }
    }
    return best;
  }

  /** Returns the difference from an earlier value with its sign in the lowest bit. */
  private static int difference(int[] values, int i, int lag) {
    int difference = i < lag ? values[i] : values[i] - values[i - lag];
    return difference << 1 ^ difference >> 31;
  }

  private static int[] unpacked(byte[] bytes, int count, int lag) {
    int[] values = new int[count];
    int at = 0;
    for (int i = 0; i < count; i++) {
      int bits = bytes[at++];
      int number = bits & 0x7f;
      for (int shift = 7; bits < 0; shift += 7) {
        bits = bytes[at++];
        number |= (bits & 0x7f) << shift;
      }
      int difference = number >>> 1 ^ -(number & 1);
      values[i] = i < lag ? difference : values[i - lag] + difference;
    }
    return values;
  }

  private static @Nullable Form packed(float[] values) {
    int decimals = 0;
    short[] multiples = new short[values.length];
    for (int i = 0; i < values.length; i++) {
      int multiple = multiple(values[i], decimals);
      while (multiple == Integer.MIN_VALUE) {
        if (++decimals == TENS.length) {
          return null;
        }
        i = 0;
        multiple = multiple(values[0], decimals);
      }
      multiples[i] = (short) multiple;
    }
    float scale = TENS[decimals];
    return () -> unpacked(multiples, scale);
  }

  /** Returns a float in units of a power of ten; the least integer if that is not exact. */
  private static int multiple(float value, int decimals) {
    if (Float.floatToRawIntBits(value) == Integer.MIN_VALUE) {
      return MINUS_ZERO;
    }
    int multiple = Math.round(value * TENS[decimals]);
    boolean exact =
        Math.abs(multiple) <= Short.MAX_VALUE
            && Float.floatToRawIntBits(multiple / TENS[decimals]) == Float.floatToRawIntBits(value);
    return exact ? multiple : Integer.MIN_VALUE;
  }

  private static float[] unpacked(short[] multiples, float scale) {
    float[] values = new float[multiples.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = multiples[i] == MINUS_ZERO ? -0.0f : multiples[i] / scale;
    }
    return values;
  }

  @Override
  public synchronized String toString() {
    return form == null ? "array" : "packed array";
  }
}
