package org.selectiverenderer.enricher.preview;

import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.PlacementDrag;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * A handle of the selected objects as the picture shows it; a value.
 *
 * @param kind what it does
 * @param axis 0 for X, 1 for Y, 2 for Z: along it, about it, or normal to the plane
 * @param sign which side of a face: -1 or 1
 * @param points its outline in pixels of the picture
 */
record ObjectHandle(Kind kind, int axis, int sign, List<Vector2d> points) {
  /** Kinds of handles. */
  enum Kind {
    /** Moves along an axis of the scene. */
    AXIS,
    /** Moves in a plane of the scene. */
    PLANE,
    /** Moves over the surfaces under the mouse. */
    SURFACE,
    /** Turns about an axis of the scene. */
    RING,
    /** Moves a side of the object's own box. */
    FACE,
    /** Scales alike along all axes. */
    CORNER
  }

  private static final double LENGTH = 80;
  private static final double NEAR = 0.28;
  private static final double FAR = 0.5;
  private static final int SEGMENTS = 64;

  /** Least sine of the angle between line of sight and a plane for which its square is shown. */
  private static final double EDGE_ON = 0.1;

  /**
   * Returns the handles of objects, those that a click takes first at the beginning.
   *
   * @param scale device pixels per unit of the component
   */
  static List<ObjectHandle> of(
      PlacementDrag objects, HandleSettings.Mode mode, PictureRays rays, double scale) {
    Vector3d pivot = objects.pivot();
    double length = LENGTH * scale * rays.pixel(pivot);
    if (!(length > 0)) {
      return List.of();
    }
    return switch (mode) {
      case MOVE -> moving(pivot, length, rays);
      case TURN -> turning(pivot, length, rays);
      case SCALE -> scaling(objects, rays);
    };
  }

  private static Vector3d unit(int axis) {
    return new Vector3d().setComponent(axis, 1);
  }

  private static List<ObjectHandle> moving(Vector3dc pivot, double length, PictureRays rays) {
    List<ObjectHandle> all = new ArrayList<>();
    add(all, Kind.SURFACE, 0, 0, List.of(pivot), rays);
    Vector2d middle = rays.project(pivot).orElseThrow(); // a length is known, so it is before us
    Vector3d sight = rays.sight(middle.x, middle.y, new Vector3d());
    for (int k = 0; k < 3; k++) {
      if (Math.abs(sight.get(k)) < EDGE_ON) {
        continue; // It would be a line, which nobody sees and a drag cannot follow.
      }
      Vector3d u = unit((k + 1) % 3).mul(length);
      Vector3d v = unit((k + 2) % 3).mul(length);
      add(
          all,
          Kind.PLANE,
          k,
          0,
          List.of(
              at(pivot, u, NEAR, v, NEAR),
              at(pivot, u, FAR, v, NEAR),
              at(pivot, u, FAR, v, FAR),
              at(pivot, u, NEAR, v, FAR)),
          rays);
    }
    for (int k = 0; k < 3; k++) {
      Vector3d far = unit(k).mul(length).add(pivot);
      Vector3d near = unit(k).mul(length * 0.15).add(pivot);
      add(all, Kind.AXIS, k, 1, List.of(near, far), rays);
    }
    return all;
  }

  private static Vector3d at(Vector3dc pivot, Vector3dc u, double s, Vector3dc v, double t) {
    return new Vector3d(pivot).fma(s, u).fma(t, v);
  }

  private static List<ObjectHandle> turning(Vector3dc pivot, double radius, PictureRays rays) {
    List<ObjectHandle> all = new ArrayList<>();
    for (int k : new int[] {1, 0, 2}) {
      Vector3d u = unit((k + 1) % 3);
      Vector3d v = unit((k + 2) % 3);
      List<Vector3dc> circle = new ArrayList<>();
      for (int i = 0; i <= SEGMENTS; i++) {
        double angle = 2 * Math.PI * i / SEGMENTS;
        circle.add(at(pivot, u, radius * Math.cos(angle), v, radius * Math.sin(angle)));
      }
      add(all, Kind.RING, k, 0, circle, rays);
    }
    return all;
  }

  private static List<ObjectHandle> scaling(PlacementDrag objects, PictureRays rays) {
    List<ObjectHandle> all = new ArrayList<>();
    PlacementDrag.Item last = objects.items().get(objects.items().size() - 1);
    BoundingBox own = last.box().own();
    for (int k = 0; objects.scalesByAxis() && k < 3; k++) {
      for (int sign = -1; sign <= 1; sign += 2) {
        if (objects.length(k) > 0) {
          Vector3d face = own.min().add(own.max()).mul(0.5);
          face.setComponent(k, (sign < 0 ? own.min() : own.max()).get(k));
          add(all, Kind.FACE, k, sign, List.of(last.box().place().transformPosition(face)), rays);
        }
      }
    }
    for (int corner = 0; corner < 8; corner++) {
      Vector3d at = last.box().place().transformPosition(own.corner(corner));
      add(all, Kind.CORNER, corner, 0, List.of(at), rays);
    }
    return all;
  }

  private static void add(
      List<ObjectHandle> to,
      Kind kind,
      int axis,
      int sign,
      List<? extends Vector3dc> places,
      PictureRays rays) {
    List<Vector2d> points = new ArrayList<>();
    for (Vector3dc place : places) {
      Optional<Vector2d> point = rays.project(place);
      if (point.isEmpty()) {
        return;
      }
      points.add(point.get());
    }
    to.add(new ObjectHandle(kind, axis, sign, points));
  }

  /** Returns the distance in pixels of a point of the picture. */
  double distance(double x, double y) {
    if (points.size() == 1) {
      return points.get(0).distance(x, y);
    }
    if (kind == Kind.PLANE && outline().contains(x, y)) {
      return 0;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int i = 1; i < points.size(); i++) {
      Vector2d a = points.get(i - 1);
      Vector2d b = points.get(i);
      least = Math.min(least, Line2D.ptSegDist(a.x, a.y, b.x, b.y, x, y));
    }
    return least;
  }

  /** Returns whether it is the same handle, wherever it is shown. */
  boolean same(ObjectHandle other) {
    return kind == other.kind && axis == other.axis && sign == other.sign;
  }

  /** Returns its outline, closed for a plane. */
  Path2D outline() {
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).x, points.get(0).y);
    points.forEach(point -> path.lineTo(point.x, point.y));
    if (kind == Kind.PLANE) {
      path.closePath();
    }
    return path;
  }
}
