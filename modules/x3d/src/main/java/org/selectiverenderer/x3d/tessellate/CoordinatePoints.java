package org.selectiverenderer.x3d.tessellate;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The points that a geometry node's indices refer to.
 *
 * @param xyz x, y, z per point; the array of the node itself if that stores floats
 * @param count the number of points
 * @param bad marks the points with a NaN or infinite component; null if there are none
 */
record CoordinatePoints(float[] xyz, int count, boolean @Nullable [] bad) {

  static CoordinatePoints of(float[] xyz) {
    int count = xyz.length / 3;
    boolean[] bad = null;
    for (int i = 0; i < 3 * count; i++) {
      if (!(Math.abs(xyz[i]) < Float.POSITIVE_INFINITY)) {
        if (bad == null) {
          bad = new boolean[count];
        }
        bad[i / 3] = true;
      }
    }
    return new CoordinatePoints(xyz, count, bad);
  }

  /** Returns the points of the job's {@code coord}; none if it has no usable one. */
  static CoordinatePoints of(TessellationContext job) {
    NodeView coord = job.node().node("coord");
    if (coord == null) {
      return of(new float[0]);
    }
    return switch (coord.type().name()) {
      case "Coordinate" -> of(coord.floats("point"));
      case "CoordinateDouble" -> of(toFloats((double[]) coord.value("point")));
      case "GeoCoordinate" -> of(GeospatialTessellator.points(job, coord));
      default -> {
        job.problem("has a " + coord.type().name() + ", which is not supported; it is left out");
        yield of(new float[0]);
      }
    };
  }

  private static float[] toFloats(double[] values) {
    float[] floats = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      floats[i] = (float) values[i];
    }
    return floats;
  }
}
