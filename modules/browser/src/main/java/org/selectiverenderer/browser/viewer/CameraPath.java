package org.selectiverenderer.browser.viewer;

import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * A recorded path of the viewer: positions in the world by time, with orientations if these were
 * recorded. It is interpolated linearly, angles the short way. Immutable. {@link CameraPathReader}
 * reads one.
 */
public final class CameraPath {
  /**
   * The viewer's pose at a point of the path.
   *
   * @param orientation the rotation from the viewer's frame to the world; empty if the path has
   *     none
   */
  public record Place(Vector3d position, Optional<Quaterniond> orientation) {}

  private final double[][] rows;
  private final boolean oriented;

  /**
   * @param rows one per time, at least one, times increasing: t, x, y, z, or t, x, y, z, yaw,
   *     pitch, roll; seconds, the scene's unit of length (metres), degrees
   * @throws IllegalArgumentException if there is no row
   */
  CameraPath(double[][] rows) {
    if (rows.length == 0) {
      throw new IllegalArgumentException("a path needs a row");
    }
    this.rows = rows;
    oriented = rows[0].length == 7;
  }

  /** Returns the time of the first row in seconds. */
  public double start() {
    return rows[0][0];
  }

  /** Returns the time of the last row in seconds. */
  public double end() {
    return rows[rows.length - 1][0];
  }

  /** Returns the number of rows. */
  public int rows() {
    return rows.length;
  }

  /** Returns the time of a row, counted from 0, in seconds. */
  public double time(int row) {
    return rows[row][0];
  }

  /** Returns the duration from the first row to the last, in seconds. */
  public double duration() {
    return end() - start();
  }

  /**
   * Returns the viewer's pose at a time; before the first row that of the first, after the last row
   * that of the last.
   */
  public Place at(double time) {
    int next = after(time);
    double[] b = rows[Math.min(next, rows.length - 1)];
    double[] a = next == 0 ? b : rows[next - 1];
    double share = a == b ? 0 : (time - a[0]) / (b[0] - a[0]);
    Vector3d position =
        new Vector3d(
            between(a[1], b[1], share), between(a[2], b[2], share), between(a[3], b[3], share));
    return new Place(position, oriented ? Optional.of(orientation(a, b, share)) : Optional.empty());
  }

  /** Returns the index of the first row with a later time, or the number of rows. */
  private int after(double time) {
    int low = 0;
    int high = rows.length;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (rows[middle][0] <= time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private static double between(double a, double b, double share) {
    return a + share * (b - a);
  }

  private static Quaterniond orientation(double[] a, double[] b, double share) {
    return Viewer.orientation(
        Math.toRadians(angle(a[4], b[4], share)),
        Math.toRadians(angle(a[5], b[5], share)),
        Math.toRadians(angle(a[6], b[6], share)));
  }

  /** Interpolates between two angles in degrees, the short way. */
  private static double angle(double a, double b, double share) {
    return a + share * Math.IEEEremainder(b - a, 360);
  }
}
