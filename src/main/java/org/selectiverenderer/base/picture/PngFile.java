package org.selectiverenderer.base.picture;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** Pixels as a PNG file (ISO/IEC 15948), true colour, 8 bits. */
public final class PngFile {
  private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

  private PngFile() {}

  /**
   * The bytes of the file.
   *
   * @param rgb three bytes per pixel, rows from the top
   */
  public static byte[] of(int width, int height, byte[] rgb) {
    return file(width, height, deflated(3 * width, height, rgb));
  }

  /**
   * The bytes of the file, made as small as can be, which takes some ten times as long.
   *
   * @param rgb three bytes per pixel, rows from the top
   */
  public static byte[] small(int width, int height, byte[] rgb) {
    byte[] filtered = PngFilters.filtered(3 * width, height, rgb);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Deflater best = new Deflater(Deflater.BEST_COMPRESSION);
    try (DeflaterOutputStream deflater = new DeflaterOutputStream(out, best)) {
      deflater.write(filtered);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // an array does not fail
    } finally {
      best.end();
    }
    return file(width, height, out.toByteArray());
  }

  private static byte[] file(int width, int height, byte[] deflated) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(SIGNATURE);
    ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height);
    header.put(new byte[] {8, 2, 0, 0, 0});
    chunk(out, "IHDR", header.array());
    chunk(out, "IDAT", deflated);
    chunk(out, "IEND", new byte[0]);
    return out.toByteArray();
  }

  private static byte[] deflated(int row, int height, byte[] rgb) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (DeflaterOutputStream deflater = new DeflaterOutputStream(out)) {
      for (int y = 0; y < height; y++) {
        deflater.write(0); // no filter
        deflater.write(rgb, y * row, row);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e); // an array does not fail
    }
    return out.toByteArray();
  }

  private static void chunk(ByteArrayOutputStream out, String type, byte[] data) {
    byte[] name = type.getBytes(StandardCharsets.US_ASCII);
    CRC32 crc = new CRC32();
    crc.update(name);
    crc.update(data);
    out.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
    out.writeBytes(name);
    out.writeBytes(data);
    out.writeBytes(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
  }
}
