package org.selectiverenderer.formats.image;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.zip.Deflater;

/**
 * Encodes pixels as a small PNG file (ISO/IEC 15948) with 8 bits per sample: each row gets its best
 * filter, and the data the best compression. {@link PngEncoder} is faster.
 */
public final class CompactPngEncoder {

  /** The PNG colour types, which define the samples of a pixel. */
  public enum Samples {
    /** One byte: grey. */
    GREY(0, 1),
    /** Two bytes: grey, opacity. */
    GREY_ALPHA(4, 2),
    /** Three bytes: red, green, blue. */
    RGB(2, 3),
    /** One byte: an index into the palette. */
    PALETTE(3, 1),
    /** Four bytes: red, green, blue, opacity. */
    RGBA(6, 4);

    private final int type;
    private final int count;

    Samples(int type, int count) {
      this.type = type;
      this.count = count;
    }

    /** Returns the bytes per pixel. */
    public int count() {
      return count;
    }
  }

  private CompactPngEncoder() {}

  /**
   * Returns the bytes of the file.
   *
   * @param palette red, green and blue of up to 256 colours; empty for other colour types
   * @param pixels rows from the top
   */
  public static byte[] of(int width, int height, Samples samples, byte[] palette, byte[] pixels) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(PngEncoder.SIGNATURE);
    ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height);
    header.put(new byte[] {8, (byte) samples.type, 0, 0, 0});
    PngEncoder.chunk(out, "IHDR", header.array());
    if (samples == Samples.PALETTE) {
      PngEncoder.chunk(out, "PLTE", palette);
    }
    PngEncoder.chunk(
        out, "IDAT", deflated(filtered(width * samples.count, height, samples, pixels)));
    PngEncoder.chunk(out, "IEND", new byte[0]);
    return out.toByteArray();
  }

  private static byte[] deflated(byte[] data) {
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
    deflater.setInput(data);
    deflater.finish();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    byte[] part = new byte[1 << 16];
    while (!deflater.finished()) {
      out.write(part, 0, deflater.deflate(part));
    }
    deflater.end();
    return out.toByteArray();
  }

  /** Returns the rows, each preceded by its filter number; palette indices are not filtered. */
  private static byte[] filtered(int row, int height, Samples samples, byte[] pixels) {
    if (samples != Samples.PALETTE) {
      return PngRowFilter.filtered(row, height, samples.count, pixels);
    }
    byte[] out = new byte[(row + 1) * height];
    for (int y = 0; y < height; y++) {
      System.arraycopy(pixels, y * row, out, y * (row + 1) + 1, row);
    }
    return out;
  }
}
