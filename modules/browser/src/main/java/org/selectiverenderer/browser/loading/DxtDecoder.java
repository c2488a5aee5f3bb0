package org.selectiverenderer.browser.loading;

import java.nio.ByteBuffer;

/**
 * Decodes S3TC (DXT) images: blocks of 4 x 4 pixels, each pixel of which is one of four colours
 * interpolated between two (OpenGL, EXT_texture_compression_s3tc).
 */
final class DxtDecoder {
  private final ByteBuffer in;
  private final int size;
  private final boolean alpha;
  private final boolean interpolated;

  /**
   * @param in the file, in little-endian order
   * @param size the bytes per block: 8, or 16 with an alpha channel
   * @param alpha whether blocks of 8 bytes may have transparent pixels
   * @param interpolated whether alpha is interpolated (DXT5); otherwise it is given per pixel
   *     (DXT3)
   */
  DxtDecoder(ByteBuffer in, int size, boolean alpha, boolean interpolated) {
    this.in = in;
    this.size = size;
    this.alpha = alpha;
    this.interpolated = interpolated;
  }

  /** Writes r, g, b, a per pixel, the image's bottom row first. */
  void read(int from, int width, int height, byte[] rgba, int to) {
    int at = from;
    byte[] pixels = new byte[64];
    for (int y = 0; y < height; y += 4) {
      for (int x = 0; x < width; x += 4, at += size) {
        block(at, pixels);
        for (int i = 0; i < 16; i++) {
          int column = x + i % 4;
          int row = y + i / 4;
          if (column < width && row < height) {
            int place = to + 4 * ((height - 1 - row) * width + column);
            System.arraycopy(pixels, 4 * i, rgba, place, 4);
          }
        }
      }
    }
  }

  private void block(int at, byte[] pixels) {
    int colours = size == 16 ? at + 8 : at;
    int first = in.getShort(colours) & 0xffff;
    int second = in.getShort(colours + 2) & 0xffff;
    boolean four = size == 16 || first > second;
    int choices = in.getInt(colours + 4);
    for (int i = 0; i < 16; i++) {
      int choice = choices >>> 2 * i & 3;
      for (int c = 0; c < 3; c++) {
        int a = channel(first, c);
        int b = channel(second, c);
        int value =
            switch (choice) {
              case 0 -> a;
              case 1 -> b;
              case 2 -> four ? (2 * a + b) / 3 : (a + b) / 2;
              default -> four ? (a + 2 * b) / 3 : 0;
            };
        pixels[4 * i + c] = (byte) value;
      }
      boolean hole = alpha && !four && choice == 3;
      pixels[4 * i + 3] = (byte) (size == 16 ? opacity(at, i) : hole ? 0 : 255);
    }
  }

  private static int channel(int colour, int c) {
    return switch (c) {
      case 0 -> (colour >>> 11) * 255 / 31;
      case 1 -> (colour >>> 5 & 63) * 255 / 63;
      default -> (colour & 31) * 255 / 31;
    };
  }

  private int opacity(int at, int pixel) {
    long bits = in.getLong(at);
    if (!interpolated) {
      return (int) (bits >>> 4 * pixel & 15) * 17;
    }
    int first = (int) (bits & 255);
    int second = (int) (bits >>> 8 & 255);
    int choice = (int) (bits >>> 16 + 3 * pixel & 7);
    if (choice < 2) {
      return choice == 0 ? first : second;
    }
    if (first > second) {
      return ((8 - choice) * first + (choice - 1) * second) / 7;
    }
    return choice == 6 ? 0 : choice == 7 ? 255 : ((6 - choice) * first + (choice - 1) * second) / 5;
  }
}
