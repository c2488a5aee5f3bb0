package org.selectiverenderer.models.scene;

import org.selectiverenderer.base.decimal.DecimalFormatter;

/** Numbers as values of X3D fields. */
public final class Numbers {
  private static final int PER_LINE = 48;

  private Numbers() {}

  /** Returns numbers in the precision of X3D's floats, one after the other. */
  public static String of(double... values) {
    StringBuilder text = new StringBuilder();
    for (double value : values) {
      text.append(text.length() == 0 ? "" : " ").append(DecimalFormatter.shortest((float) value));
    }
    return text.toString();
  }

  /** Returns many numbers in several lines. */
  public static CharSequence list(float[] values) {
    StringBuilder text = new StringBuilder(8 * values.length);
    for (int i = 0; i < values.length; i++) {
      separate(text, i).append(DecimalFormatter.shortest(values[i]));
    }
    return text;
  }

  /** Returns many whole numbers in several lines. */
  public static CharSequence list(int[] values) {
    StringBuilder text = new StringBuilder(6 * values.length);
    for (int i = 0; i < values.length; i++) {
      separate(text, i).append(values[i]);
    }
    return text;
  }

  private static StringBuilder separate(StringBuilder text, int i) {
    return i == 0 ? text : text.append(i % PER_LINE == 0 ? '\n' : ' ');
  }

  /** Returns a fraction between 0 and 1. */
  public static double unit(double value) {
    return value >= 0 ? Math.min(value, 1) : 0;
  }

  /** Returns the axis and angle of a unit quaternion x, y, z, w. */
  public static double[] axisAngle(double[] quaternion) {
    double x = quaternion[0];
    double y = quaternion[1];
    double z = quaternion[2];
    double w = quaternion[3];
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length < 1e-9) {
      return new double[] {0, 0, 1, 0};
    }
    double angle = 2 * Math.atan2(length, w);
    if (angle > Math.PI) {
      return new double[] {-x / length, -y / length, -z / length, 2 * Math.PI - angle};
    }
    return new double[] {x / length, y / length, z / length, angle};
  }
}
