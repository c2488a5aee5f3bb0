package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Reads Targa files: grey, colour or palette images, with or without alpha, plain or run-length
 * encoded (Truevision TGA file format specification 2.0). The format has no signature; files are
 * recognised by the ending {@code .tga}.
 */
final class TgaDecoder {
  private static final int HEADER = 18;

  private final byte[] file;
  private final int width;
  private final int height;
  private final int bytes;
  private final int kind;
  private final boolean encoded;
  private int at;

  static boolean is(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".tga");
  }

  private TgaDecoder(byte[] file) throws IOException {
    this.file = file;
    if (file.length < HEADER) {
      throw new IOException("is a damaged image");
    }
    kind = file[2] & 7;
    encoded = (file[2] & 8) != 0;
    width = word(12);
    height = word(14);
    bytes = (file[16] & 0xff) / 8;
    boolean known =
        kind == 1 && bytes == 1 && file[1] == 1
            || kind == 2 && bytes >= 3 && bytes <= 4
            || kind == 3 && bytes == 1;
    if (!known || width == 0 || height == 0) {
      throw new IOException(
          "is a TGA image in an unsupported format (use 8-bit grey or palette, 24 or 32 bits)");
    }
  }

  private int word(int place) {
    return (file[place] & 0xff) | (file[place + 1] & 0xff) << 8;
  }

  /**
   * @throws IOException if the image cannot be read; {@link Failure#clause} gives the reason
   */
  static Texture.Image read(byte[] file, AtomicLong budget) throws IOException {
    TgaDecoder image = new TgaDecoder(file);
    ImageDecoder.spend((long) image.width * image.height, budget);
    try {
      return image.read();
    } catch (ArrayIndexOutOfBoundsException e) {
      throw new IOException("is a damaged image", e);
    }
  }

  private Texture.Image read() {
    int palette = HEADER + (file[0] & 0xff);
    int entry = (file[7] & 0xff) / 8;
    at = palette + (file[1] == 1 ? word(5) * entry : 0);
    byte[] rgba = new byte[width * height * 4];
    boolean fromTop = (file[17] & 0x20) != 0;
    boolean fromRight = (file[17] & 0x10) != 0;
    int run = 0;
    boolean repeats = false;
    for (int i = 0; i < width * height; i++) {
      if (encoded && run == 0) {
        run = (file[at] & 0x7f) + 1;
        repeats = (file[at++] & 0x80) != 0;
      }
      int x = fromRight ? width - 1 - i % width : i % width;
      int y = fromTop ? height - 1 - i / width : i / width;
      int to = 4 * (y * width + x);
      if (kind == 1) {
        copy(palette + ((file[at] & 0xff) - word(3)) * entry, entry, rgba, to);
      } else {
        copy(at, bytes, rgba, to);
      }
      run--;
      if (!encoded || !repeats || run == 0) {
        at += bytes;
      }
    }
    int size = kind == 1 ? entry : bytes;
    return new Texture.Image(width, height, size == 1 ? 1 : size, rgba);
  }

  /** Copies one pixel: grey, or blue, green, red and perhaps alpha. */
  private void copy(int from, int size, byte[] rgba, int to) {
    rgba[to] = file[size == 1 ? from : from + 2];
    rgba[to + 1] = file[size == 1 ? from : from + 1];
    rgba[to + 2] = file[from];
    rgba[to + 3] = size == 4 ? file[from + 3] : (byte) 255;
  }
}
