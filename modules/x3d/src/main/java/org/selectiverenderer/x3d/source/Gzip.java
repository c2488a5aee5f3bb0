package org.selectiverenderer.x3d.source;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** Compresses and decompresses scenes by gzip. */
public final class Gzip {
  private Gzip() {}

  /** Returns whether bytes start with the magic number of gzip. */
  public static boolean compressed(byte[] bytes) {
    return bytes.length > 1 && (bytes[0] & 0xff) == 0x1f && (bytes[1] & 0xff) == 0x8b;
  }

  /**
   * Decompresses bytes.
   *
   * @throws IOException if the compression is damaged or the content is too large, with a message
   *     to which the consequence can be appended
   */
  public static byte[] unpacked(byte[] packed) throws IOException {
    long most = ReadLimits.standard().maxBytes();
    byte[] plain;
    try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(packed))) {
      plain = in.readNBytes((int) Math.min(most, Integer.MAX_VALUE - 16));
    } catch (IOException e) {
      throw new IOException("the gzip compression is damaged or cut off", e);
    }
    if (plain.length >= most) {
      throw new IOException("the file has more than " + most + " bytes of text");
    }
    return plain;
  }

  /** Compresses bytes, reproducibly. */
  public static byte[] packed(byte[] plain) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (GZIPOutputStream packed = new GZIPOutputStream(out)) {
      packed.write(plain);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be written", e);
    }
    return out.toByteArray();
  }
}
