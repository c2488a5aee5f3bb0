package org.selectiverenderer.validation;

import java.util.Optional;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.geometry.Tessellator;

/**
 * Measures geometry nodes: those that hold most of a scene's polygons by counting, the others,
 * which are small, by making their mesh. Safe for use by several threads.
 */
final class Measurer {
  private static final float[] NOTHING = {};

  private final Tessellator tessellator = new Tessellator();

  /** Nothing for a node that is not drawn. */
  Optional<Measure> measure(NodeView geometry) {
    if (geometry.type().name().equals("IndexedFaceSet")) {
      return Optional.of(faceSet(geometry));
    }
    return tessellator
        .tessellate(geometry, new Problems())
        .map(mesh -> new Measure(mesh.polygons(), mesh.isEmpty() ? NOTHING : mesh.bounds()));
  }

  private static Measure faceSet(NodeView faces) {
    NodeView coordinates = faces.node("coord");
    if (coordinates == null || !coordinates.type().name().equals("Coordinate")) {
      return new Measure(0, NOTHING);
    }
    int polygons = 0;
    int corners = 0;
    int[] indices = faces.ints("coordIndex");
    for (int i = 0; i <= indices.length; i++) {
      if (i == indices.length || indices[i] < 0) {
        polygons += Math.max(0, corners - 2);
        corners = 0;
      } else {
        corners++;
      }
    }
    return new Measure(polygons, polygons == 0 ? NOTHING : bounds(coordinates.floats("point")));
  }

  private static float[] bounds(float[] points) {
    float[] bounds = {
      Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
      Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY
    };
    for (int i = 0; i + 2 < points.length; i += 3) {
      for (int axis = 0; axis < 3; axis++) {
        bounds[axis] = Math.min(bounds[axis], points[i + axis]);
        bounds[axis + 3] = Math.max(bounds[axis + 3], points[i + axis]);
      }
    }
    return points.length < 3 ? NOTHING : bounds;
  }
}
