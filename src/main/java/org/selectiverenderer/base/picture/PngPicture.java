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
    GREY(0, 1),
    RGB(2, 3),
    /** A number of the palette. */
    PALETTE(3, 1),
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

  /** Kinds of filters (ISO/IEC 15948, 9.2): none, left, above, their mean, Paeth's. */
  private static final int FILTERS = 5;

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
    byte[] out = new byte[(row + 1) * height];
    byte[] tried = new byte[row];
    int filters = samples == Samples.PALETTE ? 1 : FILTERS;
    for (int y = 0; y < height; y++) {
      long least = Long.MAX_VALUE;
      for (int filter = 0; filter < filters; filter++) {
        long sum = 0;
        for (int x = 0; x < row; x++) {
          int at = y * row + x;
          int left = x < samples.count ? 0 : pixels[at - samples.count] & 0xff;
          int above = y == 0 ? 0 : pixels[at - row] & 0xff;
          int both = x < samples.count || y == 0 ? 0 : pixels[at - row - samples.count] & 0xff;
          tried[x] = (byte) (pixels[at] - guess(filter, left, above, both));
          sum += Math.abs(tried[x]);
        }
        if (sum < least) {
          least = sum;
          out[y * (row + 1)] = (byte) filter;
          System.arraycopy(tried, 0, out, y * (row + 1) + 1, row);
        }
      }
    }
    return out;
  }

  private static int guess(int filter, int left, int above, int both) {
    return switch (filter) {
      case 0 -> 0;
      case 1 -> left;
      case 2 -> above;
      case 3 -> (left + above) / 2;
      default -> paeth(left, above, both);
    };
  }

  /** Whichever of the three is nearest to left + above - both (ISO/IEC 15948, 9.4). */
  private static int paeth(int left, int above, int both) {
    int sum = left + above - both;
    int toLeft = Math.abs(sum - left);
    int toAbove = Math.abs(sum - above);
    int toBoth = Math.abs(sum - both);
    if (toLeft <= toAbove && toLeft <= toBoth) {
      return left;
    }
    return toAbove <= toBoth ? above : both;
  }
}
