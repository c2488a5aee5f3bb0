package org.selectiverenderer.tracker.emulate;

import org.selectiverenderer.tracker.PoseSample;

/** Encodes the records of an InterTrax. */
final class InterTraxWriter {
  /** Length of a continuous record: header, three numbers, checksum. */
  static final int LENGTH = 8;

  /** Length of a polled record: three numbers. */
  static final int POLLED_LENGTH = 6;

  private InterTraxWriter() {}

  /** Writes a continuous record. */
  static void continuous(PoseSample pose, byte[] into) {
    into[0] = (byte) 0x80;
    polled(pose, into, 1);
    int sum = 0;
    for (int i = 0; i < LENGTH - 1; i++) {
      sum += into[i];
    }
    into[LENGTH - 1] = (byte) -sum;
  }

  /** Writes the numbers only, from an index on. */
  static void polled(PoseSample pose, byte[] into, int at) {
    number(pose.yaw(), into, at);
    number(pose.pitch(), into, at + 2);
    number(pose.roll(), into, at + 4);
  }

  private static void number(double degrees, byte[] into, int at) {
    int value = (int) Math.rint(degrees * 32768 / 180);
    into[at] = (byte) value;
    into[at + 1] = (byte) (value >> 8);
  }
}
