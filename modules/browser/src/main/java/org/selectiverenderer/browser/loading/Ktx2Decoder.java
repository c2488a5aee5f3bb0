package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Texture;

/**
 * Reads KTX2 files: plain images, cube maps and volumes in the formats of {@link Ktx2Format}, as
 * they are or compressed by zlib. Mipmap levels in the file are skipped; the GPU generates its own
 * (Khronos, KTX File Format Specification 2.0).
 */
final class Ktx2Decoder {
  private static final byte[] IDENTIFIER = {
    (byte) 0xab, 'K', 'T', 'X', ' ', '2', '0', (byte) 0xbb, '\r', '\n', 0x1a, '\n'
  };

  /** The size in bytes of the header and of the first entry of the index of levels. */
  private static final int HEADER = 104;

  /** The largest size in bytes of the names and values that a file may tell. */
  private static final int MAX_METADATA = 1 << 16;

  /** Bytes per pixel while an image is being read: four as kept, and some to spare. */
  private static final int PLAIN = 12;

  /** The same for an image that is inflated first, with up to sixteen bytes per pixel. */
  private static final int PACKED = 20;

  private final ByteBuffer in;
  private final Ktx2Format format;
  private final long width;
  private final long height;
  private final long depth;
  private final long faces;
  private final boolean packed;

  /** Returns whether a file begins as a KTX2 file does. */
  static boolean is(byte[] file) {
    return file.length >= IDENTIFIER.length
        && Arrays.equals(file, 0, IDENTIFIER.length, IDENTIFIER, 0, IDENTIFIER.length);
  }

  private Ktx2Decoder(byte[] file) throws IOException {
    if (file.length < HEADER) {
      throw endsTooEarly();
    }
    in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    width = number(20);
    height = Math.max(1, number(24));
    depth = Math.max(1, number(28));
    faces = number(36);
    switch (in.getInt(44)) {
      case 0 -> packed = false;
      case 1 -> throw basis();
      case 2 ->
          throw new IOException(
              "is a KTX2 image compressed by Zstandard, which is not read (write it with zlib or"
                  + " without supercompression)");
      case 3 -> packed = true;
      default -> throw new IOException("is a KTX2 image with an unknown supercompression");
    }
    if (in.getInt(12) == 0) {
      throw basis();
    }
    format = Ktx2Format.of(in.getInt(12));
    if (width < 1 || faces != 1 && faces != CubeTexture.FACES || faces > 1 && depth > 1) {
      throw new IOException("is a damaged KTX2 image: its size is impossible");
    }
    if (number(32) > 1) {
      throw new IOException("is a KTX2 file of several images, and X3D has no texture of such");
    }
  }

  private static IOException basis() {
    return new IOException(
        "is a KTX2 image of Basis Universal, which is not read (decode it with `ktx transcode"
            + " --target bc3`)");
  }

  private static IOException endsTooEarly() {
    return new IOException("is a damaged KTX2 image: it ends too early");
  }

  private long number(int at) {
    return in.getInt(at) & 0xffffffffL;
  }

  /**
   * @throws IOException if the image cannot be read; {@link Failure#clause} gives the reason
   */
  static Texture.Image read(byte[] file, AtomicLong budget) throws IOException {
    Ktx2Decoder image = new Ktx2Decoder(file);
    // Sizes in a damaged file may be so large that their product overflows a long.
    double pixels = (double) image.width * image.height * image.depth * image.faces;
    ImageDecoder.spend((long) Math.min(pixels, 1e15), image.packed ? PACKED : PLAIN, budget);
    return image.read();
  }

  private Texture.Image read() throws IOException {
    int layers = (int) (depth * faces);
    long slice = format.size(width, height);
    long size = slice * layers;
    ByteBuffer pixels = pixels(size);
    int columns = (int) width;
    int rows = (int) height;
    int picture = columns * rows * 4;
    byte[] rgba = new byte[Math.multiplyExact(picture, layers)];
    ToneMapper tones = new ToneMapper();
    boolean upward = metadata("KTXorientation").map(told -> told.indexOf('u') == 1).orElse(false);
    for (int i = 0; i < layers; i++) {
      int to = (faces > 1 ? CubeFaces.layer(i) : i) * picture;
      format.decode(pixels, (int) (i * slice), columns, rows, rgba, to, tones);
      if (upward) {
        turnOver(rgba, to, 4 * columns, rows);
      }
      if (faces > 1) {
        CubeFaces.asSeenFromInside(rgba, to, columns, rows, i);
      }
    }
    boolean alpha = format.channels() == 4 && DdsDecoder.translucent(rgba);
    int components = format.channels() == 1 ? 1 : alpha ? 4 : 3;
    return new Texture.Image(columns, rows, layers, components, rgba);
  }

  /** Returns the bytes of the largest level. */
  private ByteBuffer pixels(long size) throws IOException {
    long from = in.getLong(80);
    long length = in.getLong(88);
    long unpacked = in.getLong(96);
    if (from < HEADER || length < 0 || from > in.limit() || length > in.limit() - from) {
      throw endsTooEarly();
    }
    if ((packed ? unpacked : length) < size) {
      throw new IOException("is a damaged KTX2 image: it holds fewer pixels than it announces");
    }
    return packed
        ? ByteBuffer.wrap(inflate((int) from, (int) length, size)).order(ByteOrder.LITTLE_ENDIAN)
        : in.slice((int) from, (int) length).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * @param size the number of bytes that the image needs, which is bounded by the limit of pixels
   */
  private byte[] inflate(int from, int length, long size) throws IOException {
    Inflater inflater = new Inflater();
    try {
      byte[] bytes = new byte[Math.toIntExact(size)];
      inflater.setInput(in.array(), from, length);
      int done = 0;
      while (done < bytes.length) {
        int more = inflater.inflate(bytes, done, bytes.length - done);
        if (more == 0) {
          throw endsTooEarly(); // finished, or in want of input or of a dictionary
        }
        done += more;
      }
      return bytes;
    } catch (DataFormatException e) {
      throw new IOException("is a damaged KTX2 image: its pixels are no zlib data", e);
    } finally {
      inflater.end();
    }
  }

  /** Returns a value that the file tells under a name. */
  private Optional<String> metadata(String name) {
    long from = number(56);
    long length = Math.min(number(60), MAX_METADATA);
    if (from > in.limit() || length > in.limit() - from) {
      return Optional.empty();
    }
    long end = from + length;
    for (long at = from; at + 4 <= end; ) {
      long size = number((int) at);
      at += 4;
      if (size > end - at) {
        return Optional.empty();
      }
      String entry = new String(in.array(), (int) at, (int) size, StandardCharsets.UTF_8);
      if (entry.startsWith(name + '\0')) {
        return Optional.of(entry.substring(name.length() + 1));
      }
      at += (size + 3) / 4 * 4;
    }
    return Optional.empty();
  }

  private static void turnOver(byte[] rgba, int from, int row, int rows) {
    byte[] kept = new byte[row];
    for (int y = 0; y < rows / 2; y++) {
      int low = from + y * row;
      int high = from + (rows - 1 - y) * row;
      System.arraycopy(rgba, low, kept, 0, row);
      System.arraycopy(rgba, high, rgba, low, row);
      System.arraycopy(kept, 0, rgba, high, row);
    }
  }
}
