package org.selectiverenderer.browser.picking;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Intersectiond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.HitAttributes;
import org.selectiverenderer.browser.nodes.picking.PickResult;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Picks with lines (X3D 4.0, LinePickSensor, 38.4.1). Shapes are sorted by the distance of the
 * intersection from the beginning of the line.
 */
final class LinePicker implements Picker {
  /** Largest number of intersections of a line with one shape. */
  private static final int MOST = 10_000;

  private record Line(Vector3dc from, Vector3dc way) {}

  private final List<Line> lines = new ArrayList<>();
  private final BoundingBox box;

  LinePicker(Mesh mesh) {
    int[] indices = mesh.primitive() == Mesh.Primitive.LINES ? mesh.indices() : new int[0];
    for (int i = 0; i + 1 < indices.length; i += 2) {
      Vector3d from = vertex(mesh, indices[i]);
      lines.add(new Line(from, vertex(mesh, indices[i + 1]).sub(from)));
    }
    box = lines.isEmpty() ? BoundingBox.EMPTY : BoundingBox.of(mesh.bounds());
  }

  private static Vector3d vertex(Mesh mesh, int index) {
    float[] p = mesh.positions();
    return new Vector3d(p[3 * index], p[3 * index + 1], p[3 * index + 2]);
  }

  @Override
  public BoundingBox box() {
    return box;
  }

  @Override
  public Optional<Met> bounds(PickTarget target) {
    double nearest = Double.POSITIVE_INFINITY;
    for (Line line : lines) {
      Vector3d end = line.from().add(line.way(), new Vector3d());
      Vector2d at = new Vector2d();
      int side =
          Intersectiond.intersectLineSegmentAab(
              target.toWorld().transformPosition(line.from(), new Vector3d()),
              target.toWorld().transformPosition(end),
              target.box().min(),
              target.box().max(),
              at);
      if (side != Intersectiond.OUTSIDE) {
        double share = side == Intersectiond.INSIDE ? 0 : Math.max(0, Math.min(at.x, at.y));
        nearest = Math.min(nearest, share * line.way().length());
      }
    }
    return nearest == Double.POSITIVE_INFINITY
        ? Optional.empty()
        : Optional.of(new Met(nearest, List.of()));
  }

  @Override
  public Optional<Met> mesh(PickTarget target) {
    List<PickResult.Place> places = new ArrayList<>();
    double nearest = Double.POSITIVE_INFINITY;
    for (Line line : lines) {
      int before = places.size();
      follow(line, target, places);
      if (places.size() > before) {
        nearest = Math.min(nearest, places.get(before).point().distance(line.from()));
      }
    }
    return places.isEmpty() ? Optional.empty() : Optional.of(new Met(nearest, places));
  }

  /** Adds the intersections of a line with surfaces, in order along the line. */
  private static void follow(Line line, PickTarget target, List<PickResult.Place> places) {
    Vector3d start = target.fromSensor().transformPosition(line.from(), new Vector3d());
    Vector3d way = target.fromSensor().transformDirection(line.way(), new Vector3d());
    double from = 0;
    for (int i = 0; i < MOST && from <= 1; i++) {
      Optional<MeshBvh.MeshHit> hit =
          target
              .tree()
              .nearest(new Vector3d(start).fma(from, way), way, 1 - from, MeshBvh.Sides.BOTH);
      if (hit.isEmpty()) {
        return;
      }
      double at = from + hit.get().distance();
      places.add(place(line, at, target, hit.get()));
      from = at + 1e-9;
    }
  }

  private static PickResult.Place place(
      Line line, double at, PickTarget target, MeshBvh.MeshHit hit) {
    Vector2d texCoord = HitAttributes.texCoord(target.mesh(), hit);
    return new PickResult.Place(
        new Vector3d(line.from()).fma(at, line.way()),
        HitAttributes.normal(target.mesh(), target.tree(), hit, target.toSensor(), line.way()),
        texCoord == null ? null : new Vector3d(texCoord, 0));
  }
}
