package org.selectiverenderer.modelling;

import java.util.Arrays;
import org.selectiverenderer.geometry.DegreeMath;

/**
 * An open curve in the plane, built segment by segment: the profile of a lathe (x is the radius, y
 * the height) or, closed, an {@link SimplePolygon}. Immutable; every method that adds a segment
 * returns a longer curve.
 */
public final class ProfileCurve {
  private final double[] xy;

  private ProfileCurve(double[] xy) {
    this.xy = xy;
  }

  public static ProfileCurve from(double x, double y) {
    return new ProfileCurve(new double[] {x, y});
  }

  /** Returns the polyline through the points, x, y each. */
  public static ProfileCurve of(double... xy) {
    if (xy.length < 2 || xy.length % 2 != 0) {
      throw new IllegalArgumentException("a curve has x and y of each of its points");
    }
    return new ProfileCurve(xy.clone());
  }

  public ProfileCurve line(double x, double y) {
    return plus(x, y);
  }

  /** Appends an arc about a centre, counter-clockwise for positive degrees, of so many segments. */
  public ProfileCurve arc(double centreX, double centreY, double degrees, int steps) {
    double dx = xy[xy.length - 2] - centreX;
    double dy = xy[xy.length - 1] - centreY;
    double[] more = new double[2 * steps];
    for (int i = 1; i <= steps; i++) {
      double s = DegreeMath.sin(degrees * i / steps);
      double c = DegreeMath.cos(degrees * i / steps);
      more[2 * i - 2] = centreX + c * dx - s * dy;
      more[2 * i - 1] = centreY + s * dx + c * dy;
    }
    return plus(more);
  }

  /** Appends a cubic Bezier curve to (x, y) with two control points. */
  public ProfileCurve bezier(
      double x1, double y1, double x2, double y2, double x, double y, int steps) {
    double x0 = xy[xy.length - 2];
    double y0 = xy[xy.length - 1];
    double[] more = new double[2 * steps];
    for (int i = 1; i <= steps; i++) {
      double t = (double) i / steps;
      double s = 1 - t;
      double b0 = s * s * s;
      double b1 = 3 * s * s * t;
      double b2 = 3 * s * t * t;
      double b3 = t * t * t;
      more[2 * i - 2] = b0 * x0 + b1 * x1 + b2 * x2 + b3 * x;
      more[2 * i - 1] = b0 * y0 + b1 * y1 + b2 * y2 + b3 * y;
    }
    return plus(more);
  }

  /**
   * Appends a Catmull-Rom spline through the points, x, y each, with {@code steps} segments between
   * two points.
   */
  public ProfileCurve spline(int steps, double... through) {
    double[] points = new double[through.length + 2];
    points[0] = xy[xy.length - 2];
    points[1] = xy[xy.length - 1];
    System.arraycopy(through, 0, points, 2, through.length);
    double[] smooth = CatmullRomSpline.through(points, 2, false, steps);
    return plus(Arrays.copyOfRange(smooth, 2, smooth.length));
  }

  /** Appends the other curve's points. */
  public ProfileCurve then(ProfileCurve other) {
    return plus(other.xy);
  }

  /** Returns the curve with its points in reverse order. */
  public ProfileCurve reversed() {
    double[] turned = new double[xy.length];
    for (int i = 0; i < xy.length; i += 2) {
      turned[i] = xy[xy.length - 2 - i];
      turned[i + 1] = xy[xy.length - 1 - i];
    }
    return new ProfileCurve(turned);
  }

  /**
   * Returns the outline of the curve and its mirror image in the y axis; the curve must be drawn
   * upwards or downwards on one side of the axis.
   */
  public SimplePolygon closedWithMirrorX() {
    double[] mirrored = reversed().xy;
    for (int i = 0; i < mirrored.length; i += 2) {
      mirrored[i] = -mirrored[i];
    }
    return SimplePolygon.of(plus(mirrored).xy);
  }

  /** Returns the outline that joins the last point to the first. */
  public SimplePolygon closed() {
    return SimplePolygon.of(xy);
  }

  public int size() {
    return xy.length / 2;
  }

  public double x(int index) {
    return xy[2 * index];
  }

  public double y(int index) {
    return xy[2 * index + 1];
  }

  private ProfileCurve plus(double... more) {
    double[] all = Arrays.copyOf(xy, xy.length + more.length);
    System.arraycopy(more, 0, all, xy.length, more.length);
    return new ProfileCurve(all);
  }
}
