package org.selectiverenderer.browser.movie.mpeg;

import java.util.Arrays;

/** Extracts the first video stream from an MPEG-1 system stream or an MPEG-2 program stream. */
final class SystemStreamDemuxer {
  private static final int PACK = 0xba;
  private static final int FIRST_VIDEO = 0xe0;
  private static final int LAST_VIDEO = 0xef;

  private SystemStreamDemuxer() {}

  /** Returns whether a file is such a stream. */
  static boolean is(byte[] file) {
    return startCode(file, 0) == PACK;
  }

  /**
   * Returns the start code at a position, 0 to 255; -1 for none.
   *
   * @param at the position at which the bytes 0, 0, 1 and the code would be
   */
  static int startCode(byte[] data, int at) {
    return at + 3 < data.length && data[at] == 0 && data[at + 1] == 0 && data[at + 2] == 1
        ? data[at + 3] & 0xff
        : -1;
  }

  /** Returns the bytes of the video; an empty array if the stream has no video. */
  static byte[] video(byte[] file) {
    byte[] video = new byte[file.length];
    int length = 0;
    int wanted = -1;
    int at = 0;
    while (at + 6 <= file.length) {
      int code = startCode(file, at);
      if (code == -1) {
        at++;
      } else if (code <= PACK) {
        at += 4; // A pack header contains no start code.
      } else {
        int end = Math.min(file.length, at + 6 + number(file, at + 4));
        if (code >= FIRST_VIDEO && code <= LAST_VIDEO && (wanted == -1 || code == wanted)) {
          wanted = code;
          int from = payload(file, at + 6, end);
          System.arraycopy(file, from, video, length, end - from);
          length += end - from;
        }
        at = end;
      }
    }
    return Arrays.copyOf(video, length);
  }

  /** Returns the position of a packet's payload, after its header (ISO/IEC 11172-1, 2.4.3.3). */
  static int payload(byte[] file, int from, int end) {
    int at = from;
    if (at + 3 <= end && (file[at] & 0xc0) == 0x80) { // MPEG-2: gives its length.
      return Math.min(end, at + 3 + (file[at + 2] & 0xff));
    }
    while (at < end && file[at] == (byte) 0xff) {
      at++;
    }
    if (at < end && (file[at] & 0xc0) == 0x40) {
      at += 2; // The size of the decoder's buffer.
    }
    int stamps = at < end ? file[at] & 0xf0 : 0;
    return Math.min(end, at + (stamps == 0x20 ? 5 : stamps == 0x30 ? 10 : 1));
  }

  private static int number(byte[] file, int at) {
    return (file[at] & 0xff) << 8 | file[at + 1] & 0xff;
  }
}
