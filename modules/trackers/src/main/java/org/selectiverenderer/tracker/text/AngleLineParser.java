package org.selectiverenderer.tracker.text;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;
import org.selectiverenderer.tracker.pipeline.PoseSink;

/**
 * Parses a line of three numbers, {@code yaw pitch roll} in degrees, separated by spaces or tabs,
 * or by two commas. A line with another number of commas is rejected, as a comma may be meant as a
 * decimal point.
 */
public final class AngleLineParser implements LineSplitter.Records {
  private final double[] angles = new double[3];

  @Override
  public boolean read(byte[] line, int length, long arrival, PoseSink intake) {
    int commas = commas(line, length);
    if (commas != 0 && commas != angles.length - 1) {
      return false;
    }
    int at = 0;
    for (int i = 0; i < angles.length; i++) {
      at = spaces(line, at, length);
      int end = word(line, at, length);
      if (end == at || !number(line, at, end, i)) {
        return false;
      }
      at = spaces(line, end, length);
      if (commas > 0 && i < angles.length - 1) {
        if (at == length || line[at] != ',') {
          return false;
        }
        at++;
      }
    }
    if (at != length) {
      return false;
    }
    intake.angles(arrival, angles[0], angles[1], angles[2]);
    return true;
  }

  private static int commas(byte[] line, int length) {
    int commas = 0;
    for (int i = 0; i < length; i++) {
      commas += line[i] == ',' ? 1 : 0;
    }
    return commas;
  }

  private boolean number(byte[] line, int from, int to, int index) {
    try {
      angles[index] = JavaDoubleParser.parseDouble(line, from, to - from);
      return true;
    } catch (NumberFormatException e) {
      return false; // The line is counted as bad.
    }
  }

  private static int spaces(byte[] line, int from, int length) {
    int at = from;
    while (at < length && blank(line[at])) {
      at++;
    }
    return at;
  }

  private static int word(byte[] line, int from, int length) {
    int at = from;
    while (at < length && !blank(line[at]) && line[at] != ',') {
      at++;
    }
    return at;
  }

  private static boolean blank(byte b) {
    return b == ' ' || b == '\t';
  }
}
