package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;

/**
 * A path in space along which a section is swept, like the spine of X3D's Extrusion.
 *
 * @param points at least two points, no two neighbours equal
 * @param closed whether the last point joins the first
 */
public record Spine(List<Vector3d> points, boolean closed) {

  public Spine {
    points = List.copyOf(points);
    if (points.size() < 2) {
      throw new IllegalArgumentException("a spine has two points at least");
    }
  }

  /** Returns the polyline through the points, x, y, z each. */
  public static Spine of(double... xyz) {
    return from(xyz, false);
  }

  /** Returns the closed polyline through the points. */
  public static Spine loop(double... xyz) {
    return from(xyz, true);
  }

  /**
   * Returns a Catmull-Rom spline through the points, with {@code steps} segments between two
   * points.
   */
  public static Spine smooth(int steps, double... xyz) {
    return from(CatmullRomSpline.through(xyz, 3, false, steps), false);
  }

  /** Returns a closed Catmull-Rom spline through the points. */
  public static Spine smoothLoop(int steps, double... xyz) {
    return from(CatmullRomSpline.through(xyz, 3, true, steps), true);
  }

  /** Returns a helix about the y axis from y = 0 upwards, for a spring or a telephone's cord. */
  public static Spine helix(double radius, double rise, double turns, int stepsPerTurn) {
    return new Spine(turns(radius, rise, turns, (int) Math.round(turns * stepsPerTurn)), false);
  }

  private static List<Vector3d> turns(double radius, double rise, double turns, int steps) {
    List<Vector3d> points = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double angle = 360 * turns * i / steps;
      points.add(
          new Vector3d(
              radius * DegreeMath.cos(angle), rise * i / steps, -radius * DegreeMath.sin(angle)));
    }
    return points;
  }

  /** Returns a plane curve as a path at z = 0. */
  public static Spine of(ProfileCurve curve) {
    List<Vector3d> points = new ArrayList<>();
    for (int i = 0; i < curve.size(); i++) {
      points.add(new Vector3d(curve.x(i), curve.y(i), 0));
    }
    return new Spine(points, false);
  }

  /** Returns an outline as a closed path at z = 0, for a picture's frame. */
  public static Spine of(SimplePolygon outline) {
    return new Spine(of(ProfileCurve.of(outline.points())).points, true);
  }

  private static Spine from(double[] xyz, boolean closed) {
    List<Vector3d> points = new ArrayList<>();
    for (int i = 0; i < xyz.length; i += 3) {
      points.add(new Vector3d(xyz[i], xyz[i + 1], xyz[i + 2]));
    }
    return new Spine(points, closed);
  }
}
