package org.selectiverenderer.tracker.serial;

import org.selectiverenderer.tracker.pipeline.PoseSink;

/**
 * Decodes the InterTrax's continuous records from a stream of bytes.
 *
 * <p>A record has 8 bytes: 0x80, azimuth, elevation and twist as little-endian 16-bit numbers
 * (32768 is 180 degrees), and a byte that makes the sum of all 8 a multiple of 256. As 0x80 also
 * occurs inside of records, the decoder locks to the stream only where two valid records follow
 * each other, and resynchronizes after an invalid one.
 */
final class InterTraxRecordDecoder {
  static final int LENGTH = 8;
  private static final byte HEADER = (byte) 0x80;
  private static final double DEGREES = 180.0 / 32768;

  private final byte[] bytes = new byte[4096];
  private int end;
  private boolean locked;
  private boolean everLocked;
  private int skipped;

  /** Returns whether the decoder is locked to the beginnings of records. */
  boolean locked() {
    return locked;
  }

  /** Decodes bytes as they arrived, and passes each complete record to the sink. */
  void take(byte[] from, int count, long arrival, PoseSink intake) {
    int taken = 0;
    while (taken < count) {
      int piece = Math.min(count - taken, bytes.length - end);
      System.arraycopy(from, taken, bytes, end, piece);
      end += piece;
      taken += piece;
      int at = read(arrival, intake);
      System.arraycopy(bytes, at, bytes, 0, end - at);
      end -= at;
    }
  }

  /** Decodes complete records; returns the index of the first byte that is still needed. */
  private int read(long arrival, PoseSink intake) {
    int at = 0;
    while (end - at >= (locked ? LENGTH : 2 * LENGTH)) {
      if (locked && valid(at)) {
        intake.angles(
            arrival, number(at + 1) * DEGREES, number(at + 3) * DEGREES, number(at + 5) * DEGREES);
        at += LENGTH;
      } else if (locked) {
        locked = false;
        skipped = 0;
      } else if (valid(at) && valid(at + LENGTH)) {
        locked = true;
        everLocked = true;
      } else {
        at++;
        skip(intake);
      }
    }
    return at;
  }

  /**
   * Counts a bad record for every 8 skipped bytes or part of them, except for the rest of the
   * record during which the port was opened.
   */
  private void skip(PoseSink intake) {
    if (skipped++ % LENGTH == (everLocked ? 0 : LENGTH - 1)) {
      intake.bad();
    }
  }

  private boolean valid(int at) {
    int sum = 0;
    for (int i = at; i < at + LENGTH; i++) {
      sum += bytes[i];
    }
    return bytes[at] == HEADER && (sum & 0xFF) == 0;
  }

  private int number(int at) {
    return (short) ((bytes[at] & 0xFF) | bytes[at + 1] << 8);
  }
}
