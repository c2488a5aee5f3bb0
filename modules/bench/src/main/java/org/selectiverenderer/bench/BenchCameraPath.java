package org.selectiverenderer.bench;

import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * The camera path through the heavy scene: a closed path of 20 s at eye height, as a CSV file for
 * our own browser and as interpolators for other browsers.
 */
final class BenchCameraPath {

  static final double SECONDS = 20;

  private static final double EYE = 1.7;
  private static final int KEYS = 40;

  /** Seconds, x, z in metres, yaw and pitch in degrees; yaw 0 looks along -Z, positive left. */
  private static final double[][] STOPS = {
    {0, -8, 3.2, -60, -14},
    {5, -2, 0.5, -80, -18},
    {10, 4, -2, -110, -20},
    {13, 7.5, -2.5, -215, -20},
    {16, 4, 0.5, -280, -18},
    {18, -2, 2.2, -330, -16},
    {SECONDS, -8, 3.2, -420, -14},
  };

  private BenchCameraPath() {}

  static String csv() {
    StringBuilder text = new StringBuilder("t,x,y,z,yaw,pitch,roll\n");
    for (int k = 0; k <= KEYS; k++) {
      double[] at = at(SECONDS * k / KEYS);
      text.append(
          String.format(
              Locale.ROOT,
              "%.2f,%.4f,%.1f,%.4f,%.3f,%.3f,0\n",
              SECONDS * k / KEYS,
              at[0],
              EYE,
              at[1],
              at[2],
              at[3]));
    }
    return text.toString();
  }

  /**
   * Writes a second Viewpoint, "Tour", which a TimeSensor moves; the first one, which is bound,
   * stands still.
   */
  static void write(X3dWriter out) {
    StringBuilder keys = new StringBuilder();
    StringBuilder positions = new StringBuilder();
    StringBuilder orientations = new StringBuilder();
    for (int k = 0; k <= KEYS; k++) {
      double[] at = at(SECONDS * k / KEYS);
      keys.append(DecimalFormatter.fixed((double) k / KEYS, 4)).append(' ');
      positions.append(DecimalFormatter.fixed(at[0], 4)).append(" " + EYE + " ");
      positions.append(DecimalFormatter.fixed(at[1], 4)).append(' ');
      orientations.append(orientation(Math.toRadians(at[2]), Math.toRadians(at[3])));
    }
    String first = orientation(Math.toRadians(STOPS[0][3]), Math.toRadians(STOPS[0][4])).strip();
    out.open("Viewpoint", "DEF", "Start", "description", "Start", "position", "-8 1.7 3.2");
    out.attribute("orientation", first).close();
    out.empty("Viewpoint", "DEF", "Tour", "description", "Tour", "position", "-8 1.7 3.2");
    out.empty(
        "TimeSensor",
        "DEF",
        "TourClock",
        "cycleInterval",
        Integer.toString((int) SECONDS),
        "loop",
        "true");
    interpolator(out, "Position", keys, positions);
    interpolator(out, "Orientation", keys, orientations);
    out.route("TourClock", "fraction_changed", "TourPosition", "set_fraction");
    out.route("TourClock", "fraction_changed", "TourOrientation", "set_fraction");
    out.route("TourPosition", "value_changed", "Tour", "position");
    out.route("TourOrientation", "value_changed", "Tour", "orientation");
  }

  private static void interpolator(
      X3dWriter out, String field, StringBuilder keys, StringBuilder values) {
    out.open(field + "Interpolator", "DEF", "Tour" + field);
    out.attribute("key", keys.toString().strip());
    out.attribute("keyValue", values.toString().strip()).close();
  }

  /** Returns x, z, yaw and pitch at a time, interpolated linearly between the stops. */
  private static double[] at(double t) {
    int next = 1;
    while (STOPS[next][0] < t) {
      next++;
    }
    double[] a = STOPS[next - 1];
    double[] b = STOPS[next];
    double u = (t - a[0]) / (b[0] - a[0]);
    double[] out = new double[4];
    for (int i = 0; i < out.length; i++) {
      out[i] = a[i + 1] + u * (b[i + 1] - a[i + 1]);
    }
    return out;
  }

  /** Returns yaw about Y, then pitch about X, as one rotation about an axis (SFRotation). */
  private static String orientation(double yaw, double pitch) {
    double w = Math.cos(yaw / 2) * Math.cos(pitch / 2);
    double x = Math.cos(yaw / 2) * Math.sin(pitch / 2);
    double y = Math.sin(yaw / 2) * Math.cos(pitch / 2);
    double z = -Math.sin(yaw / 2) * Math.sin(pitch / 2);
    double length = Math.sqrt(x * x + y * y + z * z);
    return String.format(
        Locale.ROOT,
        "%.5f %.5f %.5f %.5f ",
        x / length,
        y / length,
        z / length,
        2 * Math.atan2(length, w));
  }
}
