package org.selectiverenderer.render.occlusion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Finds the large flat parts of a mesh. Candidate planes come from runs of consecutive coplanar
 * triangles, since files and tessellators write walls and faces so; then every triangle is tested
 * against these planes. A mesh without such runs, for example a curved one, costs one pass over its
 * triangles.
 */
final class OccluderFinder {
  private static final int MOST_PATCHES = 16;
  private static final int MOST_EDGES = 400;

  /** The least area of a run, and of an occluder, as a share of the bounding box's surface. */
  private static final double RUN_SHARE = 1 / 1000.0;

  private static final double PATCH_SHARE = 1 / 60.0;

  private final float[] positions;
  private final int[] indices;
  private final double surface;
  private final double tolerance;
  private final List<CoplanarTriangles> parts = new ArrayList<>();
  private final double[] normal = new double[3];

  OccluderFinder(Mesh mesh) {
    positions = mesh.positions();
    indices = mesh.indices();
    float[] box = mesh.bounds();
    double x = (double) box[3] - box[0];
    double y = (double) box[4] - box[1];
    double z = (double) box[5] - box[2];
    surface = 2 * (x * y + y * z + z * x);
    tolerance =
        CoplanarTriangles.tolerance(Math.max(x, Math.max(y, z)), RasterErrorBounds.reach(box));
  }

  /** Returns the occluders, largest first. */
  List<OccluderPolygon> find() {
    if (!(surface > 0) || surface == Double.POSITIVE_INFINITY) {
      return List.of();
    }
    runs();
    parts.removeIf(part -> part.area() < PATCH_SHARE / 2 * surface);
    parts.sort(Comparator.comparingDouble(part -> -part.area()));
    List<CoplanarTriangles> largest = parts.subList(0, Math.min(MOST_PATCHES, parts.size()));
    if (!largest.isEmpty()) {
      collect(largest);
    }
    return largest.stream()
        .filter(part -> part.area() >= PATCH_SHARE * surface)
        .map(CoplanarTriangles::patch)
        .filter(patch -> patch.edges().length > 0 && patch.edges().length <= 2 * MOST_EDGES)
        .sorted(Comparator.comparingDouble(patch -> -patch.area()))
        .toList();
  }

  private void runs() {
    CoplanarTriangles run = new CoplanarTriangles(positions, indices, tolerance);
    for (int i = 0; i < indices.length; i += 3) {
      double length = normal(i);
      if (length > 0) {
        if (!run.holds(i, normal, length)) {
          run = keep(run);
          run.begin(i, normal, length);
        }
        run.grow(length / 2);
      }
    }
    keep(run);
  }

  /** Keeps a run if it is large; returns the object for the next run. */
  private CoplanarTriangles keep(CoplanarTriangles run) {
    if (run.area() < RUN_SHARE * surface) {
      return run;
    }
    for (CoplanarTriangles part : parts) {
      if (part.samePlane(run)) {
        part.grow(run.area());
        return run;
      }
    }
    parts.add(run);
    return new CoplanarTriangles(positions, indices, tolerance);
  }

  private void collect(List<CoplanarTriangles> into) {
    into.forEach(CoplanarTriangles::clear);
    for (int i = 0; i < indices.length; i += 3) {
      double length = normal(i);
      for (int p = 0; p < into.size() && length > 0; p++) {
        if (into.get(p).holds(i, normal, length)) {
          into.get(p).add(i, normal, length);
          break;
        }
      }
    }
  }

  private double normal(int i) {
    TriangleMath.normal(positions, 3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2], normal);
    return TriangleMath.length(normal);
  }
}
