package org.selectiverenderer.formats.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;

/** Encodes pixels as PNG (ISO/IEC 15948) in true colour with 8 bits per sample. */
public final class PngEncoder {
  static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

  private PngEncoder() {}

  /**
   * Encodes pixels without row filters, for speed.
   *
   * @param rgb three bytes per pixel, rows from the top
   */
  public static byte[] of(int width, int height, byte[] rgb) {
    return file(width, height, deflated(3 * width, height, rgb));
  }

  /**
   * Encodes pixels with row filters and best compression, which takes some ten times as long.
   *
   * @param pixels rows from the top, three bytes per pixel, or four with alpha
   */
  public static byte[] small(int width, int height, byte[] pixels) {
    boolean alpha = pixels.length == 4 * width * height;
    return CompactPngEncoder.of(
        width,
        height,
        alpha ? CompactPngEncoder.Samples.RGBA : CompactPngEncoder.Samples.RGB,
        new byte[0],
        pixels);
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

  static void chunk(ByteArrayOutputStream out, String type, byte[] data) {
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
