package org.selectiverenderer.tracker.text;

import org.selectiverenderer.tracker.live.PoseSink;

/**
 * An ASCII record of a Polhemus Fastrak or a compatible tracker of InterSense that was asked for
 * {@code O1,4,1}: {@code 0}, the station's character, a status character, then azimuth, elevation
 * and roll in degrees, seven characters each ({@code 012 12.50 -3.00 0.25}). There is no checksum;
 * so a line that is not of exactly that form is bad.
 */
public final class FastrakRecord implements LineSplitter.Records {
  private static final int HEADER = 3;
  private static final int WIDTH = 7;
  private static final int LENGTH = HEADER + 3 * WIDTH;
  private static final char STATION = '1';

  private final double[] angles = new double[3];

  @Override
  public boolean read(byte[] line, int length, long arrival, PoseSink intake) {
    if (length != LENGTH || line[0] != '0' || line[1] != STATION) {
      return false;
    }
    for (int i = 0; i < angles.length; i++) {
      angles[i] = number(line, HEADER + i * WIDTH);
      if (Double.isNaN(angles[i])) {
        return false;
      }
    }
    intake.angles(arrival, angles[0], angles[1], angles[2]);
    return true;
  }

  /** Spaces, a sign or none, digits, a point, digits; not a number for all else. */
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
