package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * A pixel format of KTX2 files, by its number in Vulkan ({@code VkFormat}).
 *
 * @param layout the size and kind of the numbers
 * @param channels the channels per pixel, 1 to 4
 * @param blueFirst whether blue comes first, else red
 */
record Ktx2Format(Layout layout, int channels, boolean blueFirst) {
  /** The size and kind of numbers. */
  enum Layout {
    /** Whole numbers from 0 to 255. */
    BYTES(1),
    /** Whole numbers from 0 to 65535. */
    SHORTS(2),
    /** Floating-point numbers of 16 bits, linear light. */
    HALVES(2),
    /** Floating-point numbers of 32 bits, linear light. */
    FLOATS(4),
    /** Blocks of BC1: eight bytes for 4 x 4 pixels. */
    BC1(8),
    /** Blocks of BC2: sixteen bytes for 4 x 4 pixels. */
    BC2(16),
    /** Blocks of BC3: sixteen bytes for 4 x 4 pixels. */
    BC3(16);

    private final int bytes;

    Layout(int bytes) {
      this.bytes = bytes;
    }
  }

  /**
   * Returns a format.
   *
   * @throws IOException with a clause as message if this program cannot decode it
   */
  static Ktx2Format of(int vkFormat) throws IOException {
    return switch (vkFormat) {
      case 9, 15 -> new Ktx2Format(Layout.BYTES, 1, false);
      case 16, 22 -> new Ktx2Format(Layout.BYTES, 2, false);
      case 23, 29 -> new Ktx2Format(Layout.BYTES, 3, false);
      case 30, 36 -> new Ktx2Format(Layout.BYTES, 3, true);
      case 37, 43 -> new Ktx2Format(Layout.BYTES, 4, false);
      case 44, 50 -> new Ktx2Format(Layout.BYTES, 4, true);
      case 70 -> new Ktx2Format(Layout.SHORTS, 1, false);
      case 77 -> new Ktx2Format(Layout.SHORTS, 2, false);
      case 84 -> new Ktx2Format(Layout.SHORTS, 3, false);
      case 91 -> new Ktx2Format(Layout.SHORTS, 4, false);
      case 90 -> new Ktx2Format(Layout.HALVES, 3, false);
      case 97 -> new Ktx2Format(Layout.HALVES, 4, false);
      case 106 -> new Ktx2Format(Layout.FLOATS, 3, false);
      case 109 -> new Ktx2Format(Layout.FLOATS, 4, false);
      case 131, 132 -> new Ktx2Format(Layout.BC1, 3, false);
      case 133, 134 -> new Ktx2Format(Layout.BC1, 4, false);
      case 135, 136 -> new Ktx2Format(Layout.BC2, 4, false);
      case 137, 138 -> new Ktx2Format(Layout.BC3, 4, false);
      default ->
          throw new IOException(
              "is a KTX2 image in an unsupported format, VkFormat %s (use R8G8B8A8, BC1, BC2 or BC3)"
                  .formatted(Integer.toUnsignedString(vkFormat)));
    };
  }

  private boolean blocks() {
    return layout.compareTo(Layout.BC1) >= 0;
  }

  /** Returns the bytes of a slice of that size. */
  long size(long width, long height) {
    return blocks()
        ? (width + 3) / 4 * ((height + 3) / 4) * layout.bytes
        : width * height * channels * layout.bytes;
  }

  /**
   * Decodes a slice, of which the first row is the highest.
   *
   * @param in the pixels, in little-endian order
   * @param at where the slice begins
   * @param rgba receives the slice, the lowest row first
   * @param to where it begins there
   * @param tones converts linear light
   */
  void decode(ByteBuffer in, int at, int width, int height, byte[] rgba, int to, ToneMapper tones) {
    if (blocks()) {
      new DxtDecoder(in, layout.bytes, channels == 4, layout == Layout.BC3)
          .read(at, width, height, rgba, to);
      return;
    }
    boolean light = layout == Layout.HALVES || layout == Layout.FLOATS;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int from = at + (y * width + x) * channels * layout.bytes;
        int pixel = to + 4 * ((height - 1 - y) * width + x);
        rgba[pixel + 3] = (byte) 255;
        if (light) {
          tones.write(light(in, from, 0), light(in, from, 1), light(in, from, 2), rgba, pixel);
          if (channels == 4) {
            rgba[pixel + 3] = (byte) Math.round(255 * clamped(light(in, from, 3)));
          }
          continue;
        }
        for (int c = 0; c < channels; c++) {
          // Of 16 bits the upper eight; numbers begin with the lower byte.
          byte value = in.get(from + c * layout.bytes + layout.bytes - 1);
          rgba[pixel + (blueFirst && c < 3 ? 2 - c : c)] = value;
        }
        if (channels == 1) {
          rgba[pixel + 1] = rgba[pixel];
          rgba[pixel + 2] = rgba[pixel];
        }
      }
    }
  }

  private static float clamped(float value) {
    return value > 0 ? Math.min(1, value) : 0;
  }

  private float light(ByteBuffer in, int from, int channel) {
    return layout == Layout.FLOATS
        ? in.getFloat(from + 4 * channel)
        : half(in.getShort(from + 2 * channel));
  }

  /** Returns the value of a floating-point number of 16 bits (IEEE 754, binary16). */
  private static float half(short bits) {
    int exponent = bits >> 10 & 31;
    int mantissa = bits & 1023;
    float size =
        exponent == 0
            ? Math.scalb((float) mantissa, -24)
            : exponent == 31
                ? mantissa == 0 ? Float.POSITIVE_INFINITY : Float.NaN
                : Math.scalb((float) (1024 + mantissa), exponent - 25);
    return bits < 0 ? -size : size;
  }
}
