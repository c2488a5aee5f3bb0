package org.selectiverenderer.base.picture;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.zip.Deflater;

/**
 * Pixels as a small PNG file (ISO/IEC 15948), 8 bits a sample: rows are filtered as suits each best
 * and deflated as far as goes. {@link PngFile} is the quick way.
 */
public final class PngPicture {

  /** What a pixel's samples are. */
  public enum Samples {
    /** One byte: grey. */
    GREY(0, 1),
    /** Three bytes: red, green, blue. */
    RGB(2, 3),
    /** A number of the palette. */
    PALETTE(3, 1),
    /** Four bytes: red, green, blue, opacity. */
    RGBA(6, 4);

    private final int type;
    private final int count;

    Samples(int type, int count) {
      this.type = type;
      this.count = count;
    }

    /** Bytes of a pixel. */
    public int count() {
      return count;
    }
  }

  private PngPicture() {}

  /**
   * The bytes of the file.
   *
   * @param palette red, green and blue of up to 256 colours; empty unless samples are of it
   * @param pixels rows from the top
   */
  public static byte[] of(int width, int height, Samples samples, byte[] palette, byte[] pixels) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(PngFile.SIGNATURE);
    ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height);
    header.put(new byte[] {8, (byte) samples.type, 0, 0, 0});
    PngFile.chunk(out, "IHDR", header.array());
    if (samples == Samples.PALETTE) {
      PngFile.chunk(out, "PLTE", palette);
    }
    PngFile.chunk(out, "IDAT", deflated(filtered(width * samples.count, height, samples, pixels)));
    PngFile.chunk(out, "IEND", new byte[0]);
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

  /** Each row after the number of its filter; numbers of a palette are not filtered. */
  private static byte[] filtered(int row, int height, Samples samples, byte[] pixels) {
    if (samples != Samples.PALETTE) {
      return PngFilters.filtered(row, height, samples.count, pixels);
    }
    byte[] out = new byte[(row + 1) * height];
    for (int y = 0; y < height; y++) {
      System.arraycopy(pixels, y * row, out, y * (row + 1) + 1, row);
    }
    return out;
  }
}
