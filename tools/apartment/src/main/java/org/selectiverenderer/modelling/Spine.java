package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.Degrees;

/**
 * A line in space, along which a section is swept.
 *
 * @param points two at least, no two neighbours the same
 * @param closed whether it goes on from the last point to the first
 */
public record Spine(List<Vector3d> points, boolean closed) {

  public Spine {
    points = List.copyOf(points);
    if (points.size() < 2) {
      throw new IllegalArgumentException("a spine has two points at least");
    }
  }

  /** Straight from point to point, x, y, z each. */
  public static Spine of(double... xyz) {
    return from(xyz, false);
  }

  /** Straight from point to point and back to the first. */
  public static Spine loop(double... xyz) {
    return from(xyz, true);
  }

  /** Smooth (Catmull-Rom) through the points, {@code steps} pieces between two. */
  public static Spine smooth(int steps, double... xyz) {
    return from(Splines.through(xyz, 3, false, steps), false);
  }

  /** Smooth and closed through the points. */
  public static Spine smoothLoop(int steps, double... xyz) {
    return from(Splines.through(xyz, 3, true, steps), true);
  }

  /** A screw line about the y axis from y = 0 upwards: a spring, a telephone's cord. */
  public static Spine helix(double radius, double rise, double turns, int stepsPerTurn) {
    return new Spine(turns(radius, rise, turns, (int) Math.round(turns * stepsPerTurn)), false);
  }

  private static List<Vector3d> turns(double radius, double rise, double turns, int steps) {
    List<Vector3d> points = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double angle = 360 * turns * i / steps;
      points.add(
          new Vector3d(
              radius * Degrees.cos(angle), rise * i / steps, -radius * Degrees.sin(angle)));
    }
    return points;
  }

  /** A curve of the plane as a line in space at z = 0. */
  public static Spine of(Curve curve) {
    List<Vector3d> points = new ArrayList<>();
    for (int i = 0; i < curve.size(); i++) {
      points.add(new Vector3d(curve.x(i), curve.y(i), 0));
    }
    return new Spine(points, false);
  }

  /** An outline of the plane as a closed line in space at z = 0: a picture's frame. */
  public static Spine of(Outline outline) {
    return new Spine(of(Curve.of(outline.points())).points, true);
  }

  private static Spine from(double[] xyz, boolean closed) {
    List<Vector3d> points = new ArrayList<>();
    for (int i = 0; i < xyz.length; i += 3) {
      points.add(new Vector3d(xyz[i], xyz[i + 1], xyz[i + 2]));
    }
    return new Spine(points, closed);
  }
}
