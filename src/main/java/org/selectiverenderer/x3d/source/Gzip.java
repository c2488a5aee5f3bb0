package org.selectiverenderer.x3d.source;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** Compressed scenes, whatever their files' ending. */
public final class Gzip {
  private Gzip() {}

  /** Whether bytes start like a gzip file. */
  public static boolean compressed(byte[] bytes) {
    return bytes.length > 1 && (bytes[0] & 0xff) == 0x1f && (bytes[1] & 0xff) == 0x8b;
  }

  /**
   * The bytes within.
   *
   * @throws IOException if the compression is damaged or there is more in it than a scene may have,
   *     with the first half of a sentence
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

  /** The bytes compressed; the same bytes every time. */
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
