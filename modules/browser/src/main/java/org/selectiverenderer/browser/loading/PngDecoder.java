package org.selectiverenderer.browser.loading;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Decodes PNG images (ISO/IEC 15948) of the common kinds: grey, grey with alpha, RGB, RGBA and
 * palette, 8 bits per sample, not interlaced. It writes the pixels of a texture directly: ImageIO,
 * which reads all other kinds, takes three times as long, and a tenth of a second to start.
 */
final class PngDecoder {
  private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  private static final int HEADER = chunk("IHDR");
  private static final int PALETTE = chunk("PLTE");
  private static final int DATA = chunk("IDAT");
  private static final int END = chunk("IEND");

  /** Chunks with a transparent colour and a colour profile, which are left to ImageIO. */
  private static final int TRANSPARENT = chunk("tRNS");

  private static final int PROFILE = chunk("iCCP");

  /** The colour type of palette images. */
  private static final int INDEXED = 3;

  private final ByteBuffer file;
  private final int width;
  private final int height;

  /** Samples per pixel: 1 grey or palette index, 2 grey and alpha, 3 RGB, 4 RGBA. */
  private final int samples;

  private final boolean indexed;

  /** Red, green and blue of each palette colour. */
  private byte[] palette = new byte[0];

  private PngDecoder(ByteBuffer file, int width, int height, int samples, boolean indexed) {
    this.file = file;
    this.width = width;
    this.height = height;
    this.samples = samples;
    this.indexed = indexed;
  }

  private static int chunk(String name) {
    return name.charAt(0) << 24 | name.charAt(1) << 16 | name.charAt(2) << 8 | name.charAt(3);
  }

  /** Returns whether a file begins with the PNG signature. */
  static boolean is(byte[] beginning) {
    return beginning.length >= SIGNATURE.length
        && Arrays.equals(beginning, 0, SIGNATURE.length, SIGNATURE, 0, SIGNATURE.length);
  }

  /** Reads the header; empty for the kinds that are left to ImageIO. */
  static Optional<PngDecoder> of(byte[] bytes) {
    ByteBuffer file = ByteBuffer.wrap(bytes);
    if (!is(bytes) || bytes.length < 33 || file.getInt(8) != 13 || file.getInt(12) != HEADER) {
      return Optional.empty();
    }
    int samples =
        switch (file.get(25)) {
          case 0, INDEXED -> 1;
          case 2 -> 3;
          case 4 -> 2;
          case 6 -> 4;
          default -> 0;
        };
    int width = file.getInt(16);
    int height = file.getInt(20);
    boolean plain = file.get(24) == 8 && file.get(26) == 0 && file.get(27) == 0;
    return samples > 0 && plain && file.get(28) == 0 && width > 0 && height > 0
        ? Optional.of(
            new PngDecoder(file.position(33), width, height, samples, file.get(25) == INDEXED))
        : Optional.empty();
  }

  long pixels() {
    return (long) width * height;
  }

  /** Decodes the pixels; empty if anything is wrong, which ImageIO then reports. */
  Optional<Texture.Image> decode() {
    Inflater inflater = new Inflater();
    try {
      byte[] rgba = new byte[width * height * 4];
      byte[] above = new byte[width * samples];
      byte[] row = new byte[width * samples];
      byte[] filter = new byte[1];
      for (int y = 0; y < height; y++) {
        if (!fill(inflater, filter) || !fill(inflater, row) || !unfilter(filter[0], row, above)) {
          return Optional.empty();
        }
        int at = (height - 1 - y) * width * 4;
        if (!indexed) {
          put(row, rgba, at);
        } else if (!putIndexed(row, rgba, at)) {
          return Optional.empty();
        }
        byte[] other = above;
        above = row;
        row = other;
      }
      // A palette of greys makes a greyscale image.
      int components = indexed && !ImageDecoder.isGrey(rgba) ? 3 : samples;
      return Optional.of(new Texture.Image(width, height, components, rgba));
    } catch (DataFormatException e) {
      return Optional.empty();
    } finally {
      inflater.end();
    }
  }

  /** Fills an array with inflated bytes; returns false if there are too few. */
  private boolean fill(Inflater inflater, byte[] into) throws DataFormatException {
    int at = 0;
    while (at < into.length) {
      int read = inflater.inflate(into, at, into.length - at);
      at += read;
      if (read == 0 && !(inflater.needsInput() && feed(inflater))) {
        return false;
      }
    }
    return true;
  }

  /** Feeds the next IDAT chunk to the inflater; returns false if there is none. */
  private boolean feed(Inflater inflater) {
    while (file.remaining() >= 12) {
      int length = file.getInt();
      int type = file.getInt();
      if (length < 0 || length > file.remaining() - 4 || type == END || special(type)) {
        return false;
      }
      int at = file.position();
      file.position(at + length + 4);
      if (type == DATA && length > 0) {
        inflater.setInput(file.array(), at, length);
        return true;
      }
      if (type == PALETTE) {
        palette = Arrays.copyOfRange(file.array(), at, at + length / 3 * 3);
      }
    }
    return false;
  }

  /** Returns whether a chunk changes the meaning of the samples. */
  private static boolean special(int type) {
    return type == TRANSPARENT || type == PROFILE;
  }

  /** Reverses a row's filter (clause 9.2); returns false for an unknown filter. */
  private boolean unfilter(int filter, byte[] row, byte[] above) {
    switch (filter) {
      case 0 -> {}
      case 1 -> {
        for (int i = samples; i < row.length; i++) {
          row[i] += row[i - samples];
        }
      }
      case 2 -> {
        for (int i = 0; i < row.length; i++) {
          row[i] += above[i];
        }
      }
      case 3 -> {
        for (int i = 0; i < row.length; i++) {
          int left = i < samples ? 0 : row[i - samples] & 0xff;
          row[i] += (byte) (left + (above[i] & 0xff) >> 1);
        }
      }
      case 4 -> paeth(row, above);
      default -> {
        return false;
      }
    }
    return true;
  }

  private void paeth(byte[] row, byte[] above) {
    for (int i = 0; i < samples; i++) {
      row[i] += above[i];
    }
    for (int i = samples; i < row.length; i++) {
      int left = row[i - samples] & 0xff;
      int up = above[i] & 0xff;
      int corner = above[i - samples] & 0xff;
      int a = Math.abs(up - corner);
      int b = Math.abs(left - corner);
      int c = Math.abs(left + up - 2 * corner);
      row[i] += (byte) (a <= b && a <= c ? left : b <= c ? up : corner);
    }
  }

  private void put(byte[] row, byte[] rgba, int from) {
    boolean colour = samples > 2;
    boolean alpha = samples == 2 || samples == 4;
    int at = from;
    for (int i = 0; i < row.length; i += samples) {
      rgba[at] = row[i];
      rgba[at + 1] = colour ? row[i + 1] : row[i];
      rgba[at + 2] = colour ? row[i + 2] : row[i];
      rgba[at + 3] = alpha ? row[i + samples - 1] : (byte) 255;
      at += 4;
    }
  }

  /** Returns false if an index is beyond the palette. */
  private boolean putIndexed(byte[] row, byte[] rgba, int from) {
    int at = from;
    for (byte number : row) {
      int colour = 3 * (number & 0xff);
      if (colour >= palette.length) {
        return false;
      }
      rgba[at] = palette[colour];
      rgba[at + 1] = palette[colour + 1];
      rgba[at + 2] = palette[colour + 2];
      rgba[at + 3] = (byte) 255;
      at += 4;
    }
    return true;
  }
}
