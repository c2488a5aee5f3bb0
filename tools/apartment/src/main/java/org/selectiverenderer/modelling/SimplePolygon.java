package org.selectiverenderer.modelling;

import java.util.Arrays;
import org.selectiverenderer.geometry.DegreeMath;

/**
 * A simple polygon in the plane, convex or concave, counter-clockwise. Immutable. Points that
 * repeat their predecessor are left out.
 */
public final class SimplePolygon {
  private final double[] xy;

  private SimplePolygon(double[] xy) {
    this.xy = xy;
  }

  /** Returns the polygon with these corners, x, y each, given in either direction. */
  public static SimplePolygon of(double... xy) {
    double[] distinct = new double[xy.length];
    int n = 0;
    for (int i = 0; i < xy.length; i += 2) {
      int before = n == 0 ? xy.length - 2 : n - 2;
      double[] source = n == 0 ? xy : distinct;
      if (Math.abs(xy[i] - source[before]) + Math.abs(xy[i + 1] - source[before + 1]) > 1e-9) {
        distinct[n] = xy[i];
        distinct[n + 1] = xy[i + 1];
        n += 2;
      }
    }
    if (n < 6) {
      throw new IllegalArgumentException("an outline has three corners at least");
    }
    SimplePolygon outline = new SimplePolygon(Arrays.copyOf(distinct, n));
    return outline.area() < 0 ? new SimplePolygon(outline.clockwise()) : outline;
  }

  public static SimplePolygon circle(double radius, int points) {
    return ellipse(radius, radius, points);
  }

  /** Returns an ellipse about the origin; its first point is on the x axis. */
  public static SimplePolygon ellipse(double radiusX, double radiusY, int points) {
    return superellipse(radiusX, radiusY, 2, points);
  }

  /**
   * Returns a superellipse (Lame curve): exponent 2 gives an ellipse, 4 a squarish pillow, above 10
   * nearly a rectangle, 1 a rhombus.
   */
  public static SimplePolygon superellipse(
      double radiusX, double radiusY, double exponent, int points) {
    double[] xy = new double[2 * points];
    for (int i = 0; i < points; i++) {
      double c = DegreeMath.cos(360.0 * i / points);
      double s = DegreeMath.sin(360.0 * i / points);
      xy[2 * i] = radiusX * bent(c, 2 / exponent);
      xy[2 * i + 1] = radiusY * bent(s, 2 / exponent);
    }
    return of(xy);
  }

  static double bent(double value, double power) {
    return power == 1 ? value : Math.copySign(DegreeMath.power(Math.abs(value), power), value);
  }

  /** Returns a rectangle about the origin. */
  public static SimplePolygon rectangle(double width, double height) {
    double x = width / 2;
    double y = height / 2;
    return of(-x, -y, x, -y, x, y, -x, y);
  }

  /** Returns a rectangle about the origin with round corners of {@code steps} segments each. */
  public static SimplePolygon roundedRectangle(
      double width, double height, double radius, int steps) {
    return rectangle(width, height).rounded(radius, steps);
  }

  /**
   * Returns a closed Catmull-Rom spline through the points, with {@code steps} segments between two
   * points.
   */
  public static SimplePolygon spline(int steps, double... xy) {
    return of(CatmullRomSpline.through(xy, 2, true, steps));
  }

  /**
   * Returns the outline with every corner replaced by an arc, of a smaller radius where an edge is
   * too short.
   */
  public SimplePolygon rounded(double radius, int steps) {
    return of(CornerFillet.round(xy, true, radius, steps));
  }

  public SimplePolygon move(double x, double y) {
    return affine(1, 0, 0, 1, x, y);
  }

  public SimplePolygon scale(double x, double y) {
    return affine(x, 0, 0, y, 0, 0);
  }

  /** Returns the outline rotated about the origin, counter-clockwise for positive degrees. */
  public SimplePolygon turn(double degrees) {
    double s = DegreeMath.sin(degrees);
    double c = DegreeMath.cos(degrees);
    return affine(c, -s, s, c, 0, 0);
  }

  private SimplePolygon affine(double xx, double xy, double yx, double yy, double dx, double dy) {
    double[] moved = new double[this.xy.length];
    for (int i = 0; i < moved.length; i += 2) {
      double x = this.xy[i];
      double y = this.xy[i + 1];
      moved[i] = xx * x + xy * y + dx;
      moved[i + 1] = yx * x + yy * y + dy;
    }
    return of(moved);
  }

  /**
   * Returns the outline offset inwards, with the same number of corners.
   *
   * @param distance metres; negative moves outwards
   * @throws IllegalArgumentException if the distance is so large that an edge would be reversed
   */
  public SimplePolygon inset(double distance) {
    return new SimplePolygon(PolygonOffset.inset(xy, distance));
  }

  /** Returns the enclosed area, square metres. */
  public double area() {
    double sum = 0;
    for (int i = 0, j = xy.length - 2; i < xy.length; j = i, i += 2) {
      sum += xy[j] * xy[i + 1] - xy[i] * xy[j + 1];
    }
    return sum / 2;
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

  double[] points() {
    return xy;
  }

  /** Returns the points in clockwise order, as holes have them. */
  double[] clockwise() {
    double[] turned = new double[xy.length];
    for (int i = 0; i < xy.length; i += 2) {
      turned[i] = xy[xy.length - 2 - i];
      turned[i + 1] = xy[xy.length - 1 - i];
    }
    return turned;
  }
}
