package org.selectiverenderer.apartment.scene;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.DegreeMath;

/** Formats X3D field values as text. */
final class FieldValueText {

  private FieldValueText() {}

  /** Returns numbers rounded to a tenth of a millimetre. */
  static String numbers(double... values) {
    return Arrays.stream(values)
        .mapToObj(v -> DecimalFormatter.rounded(v, 4))
        .collect(Collectors.joining(" "));
  }

  /** Returns a rotation about +y. */
  static String yaw(double degrees) {
    return "0 1 0 " + DecimalFormatter.rounded(StrictMath.toRadians(turned(degrees)), 4);
  }

  private static double turned(double degrees) {
    double rest = degrees % 360;
    return rest > 180 ? rest - 360 : rest <= -180 ? rest + 360 : rest;
  }

  /**
   * Returns a viewpoint's orientation: rotated about +y, then tilted about its own x; 0, 0 looks
   * along -z.
   */
  static String orientation(double yaw, double pitch) {
    double w = DegreeMath.cos(yaw / 2) * DegreeMath.cos(pitch / 2);
    double x = DegreeMath.cos(yaw / 2) * DegreeMath.sin(pitch / 2);
    double y = DegreeMath.sin(yaw / 2) * DegreeMath.cos(pitch / 2);
    double z = -DegreeMath.sin(yaw / 2) * DegreeMath.sin(pitch / 2);
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length < 1e-9) {
      return "0 1 0 0";
    }
    double angle = StrictMath.toRadians(2 * DegreeMath.atan2(length, w));
    return numbers(x / length, y / length, z / length, angle);
  }
}
