package org.selectiverenderer.validation.run;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.validation.GeometryMeasure;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.tessellate.Tessellator;

/**
 * Measures polygons and bounds of geometry nodes: IndexedFaceSets, which have most of a scene's
 * polygons, by counting; other nodes, which are small, by tessellation. Thread-safe.
 */
final class GeometryMeasurer {
  private static final float[] NOTHING = {};
  private static final float[] INSIDE_OUT = {
    Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
    Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY
  };

  /**
   * Up to this number of corners, a face has two triangles fewer than corners, however it is
   * triangulated.
   */
  private static final int SPLIT_SIMPLY = 4;

  /** Ten times the share of {@link TriangleMath#hasArea} by which the tessellator decides. */
  private static final double CLEAR = 1e-15;

  private final Tessellator tessellator = new Tessellator();

  /** Returns the measure of a node; empty if it is not drawn. */
  Optional<GeometryMeasure> measure(NodeView geometry) {
    GeometryMeasure counted =
        geometry.type().name().equals("IndexedFaceSet") ? faceSet(geometry) : null;
    if (counted != null) {
      return Optional.of(counted);
    }
    return tessellator
        .tessellate(geometry, new ProblemCollector())
        .map(
            mesh -> new GeometryMeasure(mesh.polygons(), mesh.isEmpty() ? NOTHING : mesh.bounds()));
  }

  /**
   * Returns the measure of an IndexedFaceSet; null if only the tessellator can determine how its
   * faces are triangulated.
   */
  private static @Nullable GeometryMeasure faceSet(NodeView faces) {
    NodeView coordinates = faces.node("coord");
    if (coordinates == null || !coordinates.type().name().equals("Coordinate")) {
      return null;
    }
    float[] points = coordinates.floats("point");
    int[] indices = faces.ints("coordIndex");
    int polygons = 0;
    int from = 0;
    float[] bounds = INSIDE_OUT.clone();
    for (int i = 0; i <= indices.length; i++) {
      if (i == indices.length || indices[i] == -1) {
        if (i - from > SPLIT_SIMPLY) {
          return null;
        }
        if (i - from > 2 && drawn(indices, from, i, points)) {
          if (!solid(indices, from, i, points)) {
            return null;
          }
          polygons += i - from - 2;
          widen(bounds, indices, from, i, points);
        }
        from = i + 1;
      }
    }
    return new GeometryMeasure(polygons, polygons == 0 ? NOTHING : bounds);
  }

  /**
   * Returns whether a face is drawn: like the tessellator, leaves out faces with a missing or
   * non-finite point.
   */
  private static boolean drawn(int[] indices, int from, int to, float[] points) {
    for (int i = from; i < to; i++) {
      int at = 3 * indices[i];
      if (at < 0
          || at + 2 >= points.length
          || !Float.isFinite(points[at] + points[at + 1] + points[at + 2])) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns whether each three neighbouring corners of a face are a triangle with a clear area; the
   * tessellator leaves triangles without area out.
   */
  private static boolean solid(int[] indices, int from, int to, float[] points) {
    int corners = to - from;
    for (int i = 0; i < corners; i++) {
      int a = 3 * indices[from + i];
      int b = 3 * indices[from + (i + 1) % corners];
      int c = 3 * indices[from + (i + 2) % corners];
      if (!TriangleMath.hasArea(points, a, b, c, CLEAR)) {
        return false;
      }
    }
    return true;
  }

  private static void widen(float[] bounds, int[] indices, int from, int to, float[] points) {
    for (int i = from; i < to; i++) {
      for (int axis = 0; axis < 3; axis++) {
        float value = points[3 * indices[i] + axis];
        bounds[axis] = Math.min(bounds[axis], value);
        bounds[axis + 3] = Math.max(bounds[axis + 3], value);
      }
    }
  }
}
