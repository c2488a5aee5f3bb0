package org.selectiverenderer.browser.movie.mpeg;

import java.io.IOException;
import java.util.Arrays;

/**
 * An MPEG-1 video stream: its size and the positions of its pictures. Immutable.
 *
 * <p>Coding order differs from display order: B pictures, which are predicted from two others, are
 * coded after both.
 */
public final class MpegVideo {
  static final int PICTURE = 0x00;
  static final int LAST_SLICE = 0xaf;
  private static final int SEQUENCE = 0xb3;
  private static final int EXTENSION = 0xb5;

  /** Largest number of pictures; the rest is left out. This many last over nine hours. */
  static final int MOST = 1 << 20;

  /** The picture types I and B (ISO/IEC 11172-2, 2.4.3.4). */
  static final int WHOLE = 1;

  static final int BETWEEN = 3;

  /** Pictures per second, by the header's number (ISO/IEC 11172-2, 2.4.3.2). */
  private static final double[] RATES = {
    25, 24000 / 1001.0, 24, 25, 30000 / 1001.0, 30, 50, 60000 / 1001.0, 60
  };

  private static final int[] INTRA_WEIGHTS = {
    8, 16, 19, 22, 26, 27, 29, 34, 16, 16, 22, 24, 27, 29, 34, 37, 19, 22, 26, 27, 29, 34, 34, 38,
    22, 22, 26, 27, 29, 34, 37, 40, 22, 26, 27, 29, 32, 35, 40, 48, 26, 27, 29, 32, 35, 40, 48, 58,
    26, 27, 29, 34, 38, 46, 56, 69, 27, 29, 35, 38, 46, 56, 69, 83
  };

  final byte[] data;
  final int[] intraWeights;
  final int[] weights;
  private final int width;
  private final int height;
  private final double rate;

  /** By coding order: the first byte, the type, and the index in display order. */
  private int[] starts = new int[64];

  private byte[] types = new byte[64];
  private int[] shown = new int[64];
  private int count;

  /** By display order: the index in coding order. */
  private final int[] coded;

  private MpegVideo(byte[] data, int header) {
    this.data = data;
    BitReader bits = new BitReader(data, header + 4, data.length);
    width = bits.read(12);
    height = bits.read(12);
    bits.skip(4); // The pixel aspect ratio.
    rate = RATES[Math.min(bits.read(4) % 16, RATES.length - 1)];
    bits.skip(18 + 1 + 10 + 1);
    intraWeights = bits.bit() ? weights(bits) : INTRA_WEIGHTS;
    int[] even = new int[64];
    Arrays.fill(even, 16);
    weights = bits.bit() ? weights(bits) : even;
    findPictures();
    coded = new int[count];
    order();
  }

  private static int[] weights(BitReader bits) {
    int[] weights = new int[64];
    for (int place : DctBlock.ZIGZAG) {
      weights[place] = bits.read(8);
    }
    return weights;
  }

  /** Returns whether a file is MPEG video, or a system stream that may contain one. */
  public static boolean is(byte[] file) {
    return SystemStreamDemuxer.is(file) || SystemStreamDemuxer.startCode(file, 0) == SEQUENCE;
  }

  /**
   * Finds the pictures of a file.
   *
   * @throws IOException if the file has no picture that can be decoded, with a clause as message
   *     that follows the file's name
   */
  public static MpegVideo of(byte[] file) throws IOException {
    byte[] data = SystemStreamDemuxer.is(file) ? SystemStreamDemuxer.video(file) : file;
    int header = next(data, 0);
    while (header < data.length && SystemStreamDemuxer.startCode(data, header) != SEQUENCE) {
      header = next(data, header + 4);
    }
    if (header >= data.length) {
      throw new IOException("holds no video");
    }
    int behind = next(data, header + 4);
    if (SystemStreamDemuxer.startCode(data, behind) == EXTENSION) {
      throw new IOException("is MPEG-2 video; only MPEG-1 video is supported");
    }
    MpegVideo video = new MpegVideo(data, header);
    if (video.width == 0 || video.height == 0 || video.count == 0) {
      throw new IOException("holds no pictures");
    }
    return video;
  }

  /**
   * Returns the position of the next start code at or after a position; the end of the data if
   * there is none.
   */
  static int next(byte[] data, int from) {
    for (int at = from; at + 3 < data.length; at++) {
      if (data[at + 2] == 1 && data[at + 1] == 0 && data[at] == 0) {
        return at;
      }
    }
    return data.length;
  }

  private void findPictures() {
    for (int at = next(data, 0); at < data.length && count < MOST; at = next(data, at + 4)) {
      if (SystemStreamDemuxer.startCode(data, at) == PICTURE && at + 5 < data.length) {
        int type = data[at + 5] >> 3 & 7;
        if (type < WHOLE || type > BETWEEN || count == 0 && type != WHOLE) {
          continue; // Starts with an I picture; D pictures (fast winding) are skipped.
        }
        if (count == starts.length) {
          starts = Arrays.copyOf(starts, 2 * count);
          types = Arrays.copyOf(types, 2 * count);
          shown = Arrays.copyOf(shown, 2 * count);
        }
        starts[count] = at;
        types[count++] = (byte) type;
      }
    }
  }

  private void order() {
    int next = 0;
    int waiting = -1;
    for (int i = 0; i < count; i++) {
      if (types[i] == BETWEEN) {
        coded[next++] = i;
      } else {
        if (waiting >= 0) {
          coded[next++] = waiting;
        }
        waiting = i;
      }
    }
    if (waiting >= 0) {
      coded[next] = waiting;
    }
    for (int i = 0; i < count; i++) {
      shown[coded[i]] = i;
    }
  }

  /** Returns the width in pixels. */
  public int width() {
    return width;
  }

  /** Returns the height in pixels. */
  public int height() {
    return height;
  }

  /** Returns the number of pictures. */
  public int pictures() {
    return count;
  }

  /** Returns the pictures per second. */
  public double rate() {
    return rate;
  }

  /** Returns whether the data end within a picture, as in an incomplete copy or download. */
  public boolean cutOff() {
    return !decoder().complete(count - 1);
  }

  /** Makes a decoder, for one thread. */
  public MpegDecoder decoder() {
    return new MpegDecoder(this);
  }

  /** Returns the index in coding order of a picture in display order. */
  int coded(int picture) {
    return coded[picture];
  }

  /** Returns the index in display order of a picture in coding order. */
  int shown(int code) {
    return shown[code];
  }

  int type(int code) {
    return types[code];
  }

  int start(int code) {
    return starts[code];
  }

  /**
   * Returns the position after a picture's last byte; headers of the next picture may lie before
   * it.
   */
  int end(int code) {
    return code + 1 < count ? starts[code + 1] : data.length;
  }

  /**
   * Returns the I picture, by its index in coding order, from which decoding must start for a
   * picture.
   */
  int keyOf(int code) {
    int key = code;
    while (key > 0 && (types[key] != WHOLE || shown[key] > shown[code])) {
      key--;
    }
    return key;
  }
}
