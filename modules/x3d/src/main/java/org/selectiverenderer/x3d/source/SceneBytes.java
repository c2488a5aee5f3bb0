package org.selectiverenderer.x3d.source;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.jspecify.annotations.Nullable;

/**
 * The bytes of a scene file, decompressed if they start with the magic number of gzip, whatever the
 * file name: many published scenes are compressed but named {@code .x3d}.
 *
 * @param bytes contains the text from 0 to {@code length}
 * @param compressed whether the file was compressed by gzip
 * @param cut the reason why the text is truncated, or null
 * @param refused the reason why the file must not be read, or null
 */
public record SceneBytes(
    byte[] bytes, int length, boolean compressed, @Nullable String cut, @Nullable String refused) {
  private static final int GZIP = 0x1f8b;
  private static final int RATIO_ASKED_FROM = 1 << 20;
  private static final int LARGEST_ARRAY = Integer.MAX_VALUE - 16;

  /**
   * The number of bytes per read. The JDK reads into a direct buffer first, which larger reads
   * would allocate again for each file that is larger than those before.
   */
  private static final int PORTION = 1 << 16;

  /**
   * Reads a stream up to its end or a limit.
   *
   * @param expected the expected length, to save copying
   * @throws IOException if the file cannot be read; damaged compression causes no exception
   */
  public static SceneBytes read(InputStream in, long expected, ReadLimits limits)
      throws IOException {
    PushbackInputStream start = new PushbackInputStream(in, 2);
    byte[] head = start.readNBytes(2);
    start.unread(head);
    boolean compressed = head.length == 2 && ((head[0] & 0xff) << 8 | (head[1] & 0xff)) == GZIP;
    if (!compressed) {
      return fill(start, expected + 1, limits, null);
    }
    try (Gunzip unpacked = new Gunzip(start)) {
      return fill(unpacked, 4 * expected, limits, unpacked);
    } catch (ZipException | EOFException e) {
      String cut = "the gzip compression is damaged at its start";
      return new SceneBytes(new byte[0], 0, true, cut, null);
    }
  }

  /** Returns the text of bytes in memory. */
  public static SceneBytes of(byte[] bytes, ReadLimits limits) {
    boolean compressed = bytes.length > 1 && ((bytes[0] & 0xff) << 8 | (bytes[1] & 0xff)) == GZIP;
    if (!compressed && bytes.length <= limits.maxBytes()) {
      return new SceneBytes(bytes, bytes.length, false, null, null);
    }
    try {
      return read(new ByteArrayInputStream(bytes), bytes.length, limits);
    } catch (IOException e) {
      throw new UncheckedIOException("memory cannot fail to be read", e);
    }
  }

  private static SceneBytes fill(
      InputStream in, long expected, ReadLimits limits, @Nullable Gunzip gunzip)
      throws IOException {
    long most = Math.min(limits.maxBytes(), LARGEST_ARRAY);
    byte[] bytes = new byte[(int) Math.max(8192, Math.min(expected, Math.min(most, 1 << 26)))];
    int length = 0;
    while (true) {
      int count;
      try {
        count = in.read(bytes, length, Math.min(PORTION, bytes.length - length));
      } catch (ZipException | EOFException e) {
        return new SceneBytes(
            bytes, length, true, "the gzip compression is damaged or cut off here", null);
      }
      if (count < 0) {
        return new SceneBytes(bytes, length, gunzip != null, null, null);
      }
      length += count;
      if (length > most) {
        return refused(
            "the file has more than "
                + most
                + " bytes of text, which is the limit; it is left out");
      }
      if (gunzip != null
          && length > RATIO_ASKED_FROM
          && (long) length > limits.maxRatio() * gunzip.compressed()) {
        return refused(
            "the compressed file grows more than "
                + limits.maxRatio()
                + " times its size when unpacked, which is not plausible for a scene; "
                + "it is left out");
      }
      if (length == bytes.length) {
        bytes = Arrays.copyOf(bytes, (int) Math.min(2L * length, most + 1));
      }
    }
  }

  private static SceneBytes refused(String reason) {
    return new SceneBytes(new byte[0], 0, false, null, reason);
  }

  /** Counts the compressed bytes it has read. */
  private static final class Gunzip extends GZIPInputStream {
    private long compressed;

    Gunzip(InputStream in) throws IOException {
      super(in, 1 << 13);
    }

    @Override
    protected void fill() throws IOException {
      super.fill();
      compressed += len;
    }

    long compressed() {
      return compressed;
    }
  }
}
