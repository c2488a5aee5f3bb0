package org.selectiverenderer.browser.movie.mpeg;

/**
 * Decodes the macroblocks of slices into a picture (ISO/IEC 11172-2, 2.4.2.7 and 2.4.4). Decoding
 * of a damaged slice ends at the error; the remaining macroblocks keep their old pixels.
 */
final class SliceDecoder {
  private static final int MEAN = 128 * 8;

  /**
   * The quantizer matrices.
   *
   * @param intra the matrix of intra blocks
   * @param difference the matrix of non-intra blocks
   */
  record Weights(int[] intra, int[] difference) {}

  /**
   * The picture being decoded and its reference pictures.
   *
   * @param across the macroblocks per row
   * @param down the rows of macroblocks
   */
  record Pictures(
      YCbCrPicture target, YCbCrPicture forward, YCbCrPicture backward, int across, int down) {}

  /**
   * The coding of motion vectors in one direction.
   *
   * @param wholePixels whether vectors are in whole pixels; otherwise in half pixels
   * @param bits the number of extra bits after each code word (r_size)
   */
  record Vectors(boolean wholePixels, int bits) {
    static final Vectors NONE = new Vectors(false, 0);
  }

  private final MpegVlcTables codes;
  private final DctBlock block;
  private final Weights weights;
  private final VlcTable types;
  private final boolean between;
  private final Pictures pictures;
  private final Vectors ahead;
  private final Vectors back;
  private final int[] means = new int[3];

  /** The last vector components: forward right, forward down, backward right, backward down. */
  private final int[] vectors = new int[4];

  /** The number of macroblocks that may still be decoded in this picture. */
  private int left;

  /** The address of the last macroblock that was decoded completely; -1 for none. */
  private int reached = -1;

  private int quantizer;
  private int lastType;

  SliceDecoder(
      MpegVlcTables codes,
      DctBlock block,
      Weights weights,
      int pictureType,
      Pictures pictures,
      Vectors ahead,
      Vectors back) {
    this.codes = codes;
    this.block = block;
    this.weights = weights;
    types = codes.types()[pictureType];
    between = pictureType == MpegVideo.BETWEEN;
    this.pictures = pictures;
    this.ahead = ahead;
    this.back = back;
    // Slices of a valid video do not overlap; those of a malicious one might take hours to decode.
    left = 2 * pictures.across() * pictures.down();
  }

  /**
   * Decodes a slice.
   *
   * @param row the row of macroblocks in which the slice starts
   */
  void read(BitReader bits, int row) {
    quantizer = bits.read(5);
    while (bits.bit() && !bits.over()) {
      bits.skip(8);
    }
    forgetMeans();
    forgetVectors();
    lastType = 0;
    int address = row * pictures.across() - 1;
    boolean first = true;
    while (!bits.over() && bits.peek(23) != 0) {
      int step = increment(bits);
      left -= first ? 1 : step;
      if (step == 0 || left < 0 || address + step >= pictures.across() * pictures.down()) {
        return;
      }
      if (!first) {
        for (int skipped = 1; skipped < step; skipped++) {
          skip(address + skipped);
        }
      }
      first = false;
      address += step;
      if (!macroblock(bits, address)) {
        return;
      }
      if (!bits.past()) {
        reached = address;
      }
    }
  }

  /**
   * Returns whether the picture's last macroblock was decoded, which no picture may omit (ISO/IEC
   * 11172-2, 2.4.2.6).
   */
  boolean complete() {
    return reached == pictures.across() * pictures.down() - 1;
  }

  /** Reads the address increment to the next macroblock; 0 if it is invalid. */
  private int increment(BitReader bits) {
    int sum = 0;
    while (true) {
      int next = codes.increment().read(bits);
      if (next == VlcTable.NONE || bits.over() || sum > left) {
        return 0; // Increments far beyond the picture are invalid, too.
      } else if (next == MpegVlcTables.ESCAPE) {
        sum += 33;
      } else if (next != MpegVlcTables.STUFFING) {
        return sum + next;
      }
    }
  }

  /**
   * Fills a skipped macroblock: in B pictures with the previous vectors, else with a copy of the
   * reference.
   */
  private void skip(int address) {
    forgetMeans();
    if (!between) {
      forgetVectors();
      predict(address, MpegVlcTables.FORWARD);
    } else {
      predict(address, lastType);
    }
  }

  private boolean macroblock(BitReader bits, int address) {
    int type = types.read(bits);
    if (type == VlcTable.NONE) {
      return false;
    }
    if ((type & MpegVlcTables.QUANTIZER) != 0) {
      quantizer = bits.read(5);
    }
    boolean intra = (type & MpegVlcTables.INTRA) != 0;
    if (intra) {
      forgetVectors();
    } else {
      forgetMeans();
      if ((type & MpegVlcTables.FORWARD) != 0) {
        if (!vector(bits, 0, ahead) || !vector(bits, 1, ahead)) {
          return false;
        }
      } else if (!between) {
        forgetVectors();
      }
      if ((type & MpegVlcTables.BACKWARD) != 0
          && (!vector(bits, 2, back) || !vector(bits, 3, back))) {
        return false;
      }
      predict(address, between ? type : type | MpegVlcTables.FORWARD);
    }
    lastType = type;
    int coded = intra ? 63 : 0;
    if ((type & MpegVlcTables.PATTERN) != 0) {
      coded = codes.pattern().read(bits);
      if (coded == VlcTable.NONE) {
        return false;
      }
    }
    for (int i = 0; i < 6; i++) {
      if ((coded & 32 >> i) != 0 && !block(bits, address, i, intra)) {
        return false;
      }
    }
    return true;
  }

  private boolean block(BitReader bits, int address, int which, boolean intra) {
    int plane = Math.max(0, which - 3);
    if (intra) {
      int size = (plane == 0 ? codes.luminance() : codes.chrominance()).read(bits);
      if (size == VlcTable.NONE) {
        return false;
      }
      if (size > 0) {
        int change = bits.read(size);
        // A clear highest bit means a negative difference.
        means[plane] += 8 * (change >> size - 1 != 0 ? change : change - (1 << size) + 1);
      }
      if (!block.intra(bits, means[plane], quantizer, weights.intra)) {
        return false;
      }
    } else if (!block.difference(bits, quantizer, weights.difference)) {
      return false;
    }
    YCbCrPicture to = pictures.target();
    int x = address % pictures.across();
    int y = address / pictures.across();
    int stride = to.stride(plane);
    int at =
        plane == 0
            ? (16 * y + which / 2 * 8) * stride + 16 * x + which % 2 * 8
            : 8 * y * stride + 8 * x;
    block.put(to.samples[plane], at, stride, !intra);
    return true;
  }

  /** Reads a vector component, coded as the difference to the previous one. */
  private boolean vector(BitReader bits, int which, Vectors coding) {
    int code = codes.motion().read(bits);
    if (code == VlcTable.NONE) {
      return false;
    }
    if (code != 0) {
      boolean negative = bits.bit();
      int size = code - 1 << coding.bits;
      if (coding.bits > 0) {
        size += bits.read(coding.bits);
      }
      size++;
      int range = 16 << coding.bits;
      int sum = vectors[which] + (negative ? -size : size);
      vectors[which] = sum < -range ? sum + 2 * range : sum >= range ? sum - 2 * range : sum;
    }
    return true;
  }

  private void predict(int address, int type) {
    boolean forward = (type & MpegVlcTables.FORWARD) != 0;
    if (forward) {
      copy(pictures.forward(), address, 0, ahead, false);
    }
    if ((type & MpegVlcTables.BACKWARD) != 0) {
      copy(pictures.backward(), address, 2, back, forward);
    }
  }

  private void copy(YCbCrPicture from, int address, int vector, Vectors coding, boolean mix) {
    int unit = coding.wholePixels ? 2 : 1;
    int right = vectors[vector] * unit;
    int down = vectors[vector + 1] * unit;
    int x = address % pictures.across();
    int y = address / pictures.across();
    YCbCrPicture to = pictures.target();
    to.predict(from, 0, 16 * x, 16 * y, 16, right, down, mix);
    for (int plane = 1; plane < 3; plane++) {
      to.predict(from, plane, 8 * x, 8 * y, 8, right / 2, down / 2, mix);
    }
  }

  private void forgetMeans() {
    means[0] = MEAN;
    means[1] = MEAN;
    means[2] = MEAN;
  }

  private void forgetVectors() {
    vectors[0] = 0;
    vectors[1] = 0;
    vectors[2] = 0;
    vectors[3] = 0;
  }
}
