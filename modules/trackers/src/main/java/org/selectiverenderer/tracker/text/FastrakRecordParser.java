package org.selectiverenderer.tracker.text;

import org.selectiverenderer.tracker.pipeline.PoseSink;

/**
 * Parses an ASCII record of a Polhemus Fastrak or a compatible tracker of InterSense with the
 * output list {@code O1,2,4,1}: {@code 0}, the station's character, a status character, then X, Y
 * and Z in centimetres, azimuth, elevation and roll in degrees, seven characters each. With the
 * output list {@code O1,4,1} the first three are missing ({@code 012 12.50 -3.00 0.25}). There is
 * no checksum, so a line that is not of exactly one of these forms is rejected.
 *
 * <p>The transmitter's X points to the front of the user, Y to his right and Z down, by default.
 */
public final class FastrakRecordParser implements LineSplitter.Records {
  private static final int HEADER = 3;
  private static final int WIDTH = 7;
  private static final int LENGTH = HEADER + 3 * WIDTH;
  private static final int LONG = HEADER + 6 * WIDTH;
  private static final double CENTIMETRES = 100;
  private static final char STATION = '1';

  private final double[] numbers = new double[6];

  @Override
  public boolean read(byte[] line, int length, long arrival, PoseSink intake) {
    if (length != LENGTH && length != LONG || line[0] != '0' || line[1] != STATION) {
      return false;
    }
    int count = (length - HEADER) / WIDTH;
    for (int i = 0; i < count; i++) {
      numbers[i] = number(line, HEADER + i * WIDTH);
      if (Double.isNaN(numbers[i])) {
        return false;
      }
    }
    if (length == LONG) {
      intake.place(numbers[1] / CENTIMETRES, -numbers[2] / CENTIMETRES, -numbers[0] / CENTIMETRES);
    }
    intake.angles(arrival, numbers[count - 3], numbers[count - 2], numbers[count - 1]);
    return true;
  }

  /** Parses spaces, an optional sign, digits, a point, digits; returns NaN for anything else. */
  private static double number(byte[] line, int from) {
    int to = from + WIDTH;
    int at = from;
    while (at < to && line[at] == ' ') {
      at++;
    }
    boolean negative = at < to && line[at] == '-';
    if (at < to && (negative || line[at] == '+')) {
      at++;
    }
    int digits = 0;
    int scale = 0;
    int value = 0;
    for (; at < to; at++) {
      if (line[at] == '.' && scale == 0 && digits > 0) {
        scale = 1;
      } else if (line[at] >= '0' && line[at] <= '9') {
        value = value * 10 + line[at] - '0';
        scale *= 10;
        digits++;
      } else {
        return Double.NaN;
      }
    }
    return scale <= 1 ? Double.NaN : (negative ? -1.0 : 1.0) * value / scale;
  }
}
