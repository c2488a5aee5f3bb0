package org.selectiverenderer.runtime.movie.mpeg;

import java.io.IOException;
import java.util.Arrays;

/**
 * A film of MPEG-1 video: its size, and where each of its pictures is. Nobody changes it.
 *
 * <p>Pictures are coded in another order than they are shown in: those that lie between two others
 * come after both.
 */
public final class MpegVideo {
  static final int PICTURE = 0x00;
  static final int LAST_SLICE = 0xaf;
  private static final int SEQUENCE = 0xb3;
  private static final int EXTENSION = 0xb5;

  /** Pictures above which the rest is left out: those of nine hours. */
  static final int MOST = 1 << 20;

  /** Types of pictures. */
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

  /** By the order of coding: the first byte, the type, and the place in the order of showing. */
  private int[] starts = new int[64];

  private byte[] types = new byte[64];
  private int[] shown = new int[64];
  private int count;

  /** By the order of showing: the place in the order of coding. */
  private final int[] coded;

  private MpegVideo(byte[] data, int header) {
    this.data = data;
    BitReader bits = new BitReader(data, header + 4, data.length);
    width = bits.read(12);
    height = bits.read(12);
    bits.skip(4); // The shape of pixels.
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
    for (int place : SampleBlock.ZIGZAG) {
      weights[place] = bits.read(8);
    }
    return weights;
  }

  /** Whether a file is MPEG video, or a stream that may hold one. */
  public static boolean is(byte[] file) {
    return SystemStream.is(file) || SystemStream.startCode(file, 0) == SEQUENCE;
  }

  /**
   * Finds the pictures of a file.
   *
   * @throws IOException with a clause that reads after the file's name, when it has none that can
   *     be decoded
   */
  public static MpegVideo of(byte[] file) throws IOException {
    byte[] data = SystemStream.is(file) ? SystemStream.video(file) : file;
    int header = next(data, 0);
    while (header < data.length && SystemStream.startCode(data, header) != SEQUENCE) {
      header = next(data, header + 4);
    }
    if (header >= data.length) {
      throw new IOException("holds no video");
    }
    int behind = next(data, header + 4);
    if (SystemStream.startCode(data, behind) == EXTENSION) {
      throw new IOException("is MPEG-2 video, of which this program knows MPEG-1 only");
    }
    MpegVideo video = new MpegVideo(data, header);
    if (video.width == 0 || video.height == 0 || video.count == 0) {
      throw new IOException("holds no pictures");
    }
    return video;
  }

  /** Where the next start code is, at a place or behind it; the end for none. */
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
      if (SystemStream.startCode(data, at) == PICTURE && at + 5 < data.length) {
        int type = data[at + 5] >> 3 & 7;
        if (type < WHOLE || type > BETWEEN || count == 0 && type != WHOLE) {
          continue; // A film begins with a whole picture; those for fast winding are passed over.
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

  /** Pixels. */
  public int width() {
    return width;
  }

  /** Pixels. */
  public int height() {
    return height;
  }

  /** How many pictures it has. */
  public int pictures() {
    return count;
  }

  /** Pictures per second. */
  public double rate() {
    return rate;
  }

  /** Whether it ends within a picture, as a film does that was not copied or downloaded whole. */
  public boolean cutOff() {
    return !decoder().complete(count - 1);
  }

  /** Makes pictures of it, for one thread. */
  public MpegDecoder decoder() {
    return new MpegDecoder(this);
  }

  /** Where in the order of coding a picture is. */
  int coded(int picture) {
    return coded[picture];
  }

  /** Where in the order of showing a picture is. */
  int shown(int code) {
    return shown[code];
  }

  int type(int code) {
    return types[code];
  }

  int start(int code) {
    return starts[code];
  }

  /** Behind a picture's last byte, and maybe headers of the next one. */
  int end(int code) {
    return code + 1 < count ? starts[code + 1] : data.length;
  }

  /** From which whole picture on, by the order of coding, one has to decode for another. */
  int keyOf(int code) {
    int key = code;
    while (key > 0 && (types[key] != WHOLE || shown[key] > shown[code])) {
      key--;
    }
    return key;
  }
}
