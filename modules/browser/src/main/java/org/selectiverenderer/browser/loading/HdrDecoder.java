package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Reads Radiance pictures: red, green and blue with a common exponent, plain or in either
 * run-length encoding (G. Ward, Real Pixels, Graphics Gems II, 1991; Radiance file formats). Light
 * becomes sRGB by {@link ToneMapper}.
 */
final class HdrDecoder {
  /** The shortest and the longest row that the newer run-length encoding stores. */
  private static final int SHORTEST = 8;

  private static final int LONGEST = 0x7fff;

  /** The largest number of bytes before the pixels. */
  private static final int MAX_HEADER = 1 << 16;

  private static final Pattern SIZE = Pattern.compile("([-+])Y (\\d{1,9}) ([-+])X (\\d{1,9})\\s*");

  private final byte[] file;
  private final int width;
  private final int height;
  private final boolean fromTop;
  private final boolean fromLeft;
  private int at;

  /** Returns whether a file begins as a Radiance picture does. */
  static boolean is(byte[] file) {
    return begins(file, "#?RADIANCE") || begins(file, "#?RGBE");
  }

  private static boolean begins(byte[] file, String word) {
    return file.length >= word.length()
        && new String(file, 0, word.length(), StandardCharsets.ISO_8859_1).equals(word);
  }

  private HdrDecoder(byte[] file) throws IOException {
    this.file = file;
    String line = line();
    while (!line.isEmpty()) {
      if (line.startsWith("FORMAT=") && !line.strip().equals("FORMAT=32-bit_rle_rgbe")) {
        throw new IOException(
            "is a Radiance picture of XYZ or unknown colours (convert it with `ra_xyze -r`)");
      }
      line = line();
    }
    Matcher size = SIZE.matcher(line());
    if (!size.matches()) {
      throw new IOException(
          "is a Radiance picture that is damaged or stored by columns (use rows: -Y height +X"
              + " width)");
    }
    fromTop = size.group(1).equals("-");
    height = Integer.parseInt(size.group(2));
    fromLeft = size.group(3).equals("+");
    width = Integer.parseInt(size.group(4));
    if (width < 1 || height < 1) {
      throw new IOException("is a damaged Radiance picture: its width or height is 0");
    }
  }

  private String line() throws IOException {
    int start = at;
    while (at < file.length && at < MAX_HEADER && file[at] != '\n') {
      at++;
    }
    if (at == file.length || at == MAX_HEADER) {
      throw endsTooEarly();
    }
    return new String(file, start, at++ - start, StandardCharsets.ISO_8859_1).stripTrailing();
  }

  private static IOException endsTooEarly() {
    return new IOException("is a damaged Radiance picture: it ends too early");
  }

  /**
   * @throws IOException if the image cannot be read; {@link Failure#clause} gives the reason
   */
  static Texture.Image read(byte[] file, AtomicLong budget) throws IOException {
    HdrDecoder image = new HdrDecoder(file);
    ImageDecoder.spend((long) image.width * image.height, budget);
    try {
      return image.read();
    } catch (ArrayIndexOutOfBoundsException e) {
      throw endsTooEarly();
    }
  }

  private Texture.Image read() throws IOException {
    ToneMapper tones = new ToneMapper();
    byte[] rgba = new byte[width * height * 4];
    byte[] row = new byte[4 * width];
    for (int y = 0; y < height; y++) {
      if (width >= SHORTEST && width <= LONGEST && newer()) {
        at += 4;
        for (int channel = 0; channel < 4; channel++) {
          channel(row, channel);
        }
      } else {
        older(row);
      }
      int start = 4 * width * (fromTop ? height - 1 - y : y);
      for (int x = 0; x < width; x++) {
        int to = start + 4 * (fromLeft ? x : width - 1 - x);
        float unit = unit(row[4 * x + 3]);
        tones.write(
            (row[4 * x] & 0xff) * unit,
            (row[4 * x + 1] & 0xff) * unit,
            (row[4 * x + 2] & 0xff) * unit,
            rgba,
            to);
        rgba[to + 3] = (byte) 255;
      }
    }
    return new Texture.Image(width, height, 3, rgba);
  }

  /** Returns the light of one step of a mantissa. */
  private static float unit(byte exponent) {
    return exponent == 0 ? 0 : Math.scalb(1f, (exponent & 0xff) - (128 + 8));
  }

  /** Returns whether a row is in the newer encoding, which begins with 2, 2 and the width. */
  private boolean newer() {
    return file[at] == 2
        && file[at + 1] == 2
        && ((file[at + 2] & 0xff) << 8 | file[at + 3] & 0xff) == width;
  }

  /** Reads one of the four channels of a row: runs of equal bytes, and bytes as they are. */
  private void channel(byte[] row, int channel) throws IOException {
    for (int x = 0; x < width; ) {
      int count = file[at++] & 0xff;
      boolean run = count > 128;
      count -= run ? 128 : 0;
      if (count == 0 || count > width - x) {
        throw new IOException("is a damaged Radiance picture: a row is longer than the picture");
      }
      for (int i = 0; i < count; i++, x++) {
        row[4 * x + channel] = file[run ? at : at + i];
      }
      at += run ? 1 : count;
    }
  }

  /** Reads a row of pixels, of which 1, 1, 1, n repeats the one before n times. */
  private void older(byte[] row) throws IOException {
    int shift = 0;
    for (int x = 0; x < width; at += 4) {
      boolean repeats = file[at] == 1 && file[at + 1] == 1 && file[at + 2] == 1;
      if (!repeats) {
        System.arraycopy(file, at, row, 4 * x++, 4);
        shift = 0;
        continue;
      }
      long count = (file[at + 3] & 0xffL) << shift;
      if (x == 0 || count > width - x || shift > 24) {
        throw new IOException("is a damaged Radiance picture: a row is longer than the picture");
      }
      for (int i = 0; i < count; i++, x++) {
        System.arraycopy(row, 4 * x - 4, row, 4 * x, 4);
      }
      shift += 8;
    }
  }
}
