package org.selectiverenderer.browser.sound;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.jspecify.annotations.Nullable;

/**
 * The whole frames of a stream of MPEG audio (ISO/IEC 11172-3, 2.4.2.3; ISO/IEC 13818-3; MPEG 2.5)
 * without what is between them: tags, other data, and a last frame that is cut off. A frame whose
 * version, layer, rate or number of channels is not the first one's is left out.
 *
 * @param bytes the frames, one after the other
 * @param count the number of frames
 * @param samples the samples of each frame and channel
 * @param rate samples per second
 * @param channels 1 or 2
 */
record MpegFrames(byte[] bytes, int count, int samples, int rate, int channels) {
  /** The samples per second of MPEG-1; MPEG-2 has half of them, MPEG 2.5 a quarter. */
  private static final int[] RATES = {44_100, 48_000, 32_000};

  /** Kilobits per second by layer and by the number in the header; 0 is none of a file. */
  private static final int[][] BIT_RATES = {
    {0, 32, 64, 96, 128, 160, 192, 224, 256, 288, 320, 352, 384, 416, 448, 0},
    {0, 32, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 384, 0},
    {0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 0}
  };

  /** The same for MPEG-2 and 2.5: layer I, and layers II and III. */
  private static final int[][] LOW_BIT_RATES = {
    {0, 32, 48, 56, 64, 80, 96, 112, 128, 144, 160, 176, 192, 224, 256, 0},
    {0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160, 0}
  };

  /** The size of a tag's own header in bytes (ID3 2.4, 3.1). */
  private static final int TAG = 10;

  /** Returns whether a file begins with a frame, perhaps after a tag. */
  static boolean begins(byte[] file) {
    return Header.of(file, tag(file)) != null;
  }

  /** Returns the bytes of a tag at the beginning; 0 for none. */
  private static int tag(byte[] file) {
    if (file.length < TAG || file[0] != 'I' || file[1] != 'D' || file[2] != '3') {
      return 0;
    }
    int size = 0;
    for (int i = 6; i < TAG; i++) {
      size = size << 7 | file[i] & 0x7f;
    }
    return Math.min(file.length, TAG + size);
  }

  /**
   * Finds the frames.
   *
   * @throws IOException with a clause as message that follows the file's name if there are none
   */
  static MpegFrames of(byte[] file) throws IOException {
    Header first = null;
    int count = 0;
    ByteArrayOutputStream kept = new ByteArrayOutputStream();
    for (int at = tag(file); at + 4 <= file.length; ) {
      Header header = Header.of(file, at);
      int end = header == null ? 0 : at + header.length;
      // The first frame counts when another or the end follows: the signature of one is short.
      boolean whole =
          header != null
              && end <= file.length
              && (first != null || end == file.length || Header.of(file, end) != null);
      if (!whole) {
        at++;
        continue;
      }
      if (first == null) {
        first = header;
      }
      if (header.like(first)) {
        kept.write(file, at, header.length);
        SoundFileReader.check(2L * first.samples() * first.channels * ++count);
      }
      at = end;
    }
    if (first == null) {
      throw new IOException("holds no sound");
    }
    return new MpegFrames(kept.toByteArray(), count, first.samples(), first.rate, first.channels);
  }

  /**
   * The header of a frame.
   *
   * @param version 0 for MPEG-1, 1 for MPEG-2, 2 for MPEG 2.5
   * @param length the bytes of the frame
   */
  private record Header(int version, int layer, int rate, int channels, int length) {
    static @Nullable Header of(byte[] file, int at) {
      if (at + 3 >= file.length || file[at] != (byte) 0xff || (file[at + 1] & 0xe0) != 0xe0) {
        return null;
      }
      int version =
          switch (file[at + 1] >> 3 & 3) {
            case 3 -> 0;
            case 2 -> 1;
            case 0 -> 2;
            default -> -1;
          };
      int layer = 4 - (file[at + 1] >> 1 & 3);
      int rate = file[at + 2] >> 2 & 3;
      if (version < 0 || layer == 4 || rate == 3) {
        return null;
      }
      int[] rates = version == 0 ? BIT_RATES[layer - 1] : LOW_BIT_RATES[layer == 1 ? 0 : 1];
      int bits = 1000 * rates[file[at + 2] >> 4 & 15];
      if (bits == 0) {
        return null;
      }
      int padding = file[at + 2] >> 1 & 1;
      int hertz = RATES[rate] >> version;
      int perFrame = layer == 3 && version > 0 ? 72 : 144;
      int length =
          layer == 1 ? 4 * (12 * bits / hertz + padding) : perFrame * bits / hertz + padding;
      int channels = (file[at + 3] & 0xc0) == 0xc0 ? 1 : 2;
      return new Header(version, layer, hertz, channels, length);
    }

    boolean like(Header other) {
      return version == other.version
          && layer == other.layer
          && rate == other.rate
          && channels == other.channels;
    }

    int samples() {
      return layer == 1 ? 384 : layer == 3 && version > 0 ? 576 : 1152;
    }
  }
}
