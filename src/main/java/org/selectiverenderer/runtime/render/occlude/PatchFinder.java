package org.selectiverenderer.runtime.render.occlude;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Finds the large flat parts of a mesh. Those begin as runs of triangles that follow each other in
 * one plane, as walls do in files and as tessellators write faces; then every triangle is looked at
 * whether it lies in one of those planes. A mesh without such runs, as curved ones are, costs no
 * more than a look at each triangle.
 */
final class PatchFinder {
  private static final int MOST_PATCHES = 48;
  private static final int MOST_EDGES = 400;

  /** The share of the bounding box's surface that makes a run, and a patch, large. */
  private static final double RUN_SHARE = 1 / 2000.0;

  private static final double PATCH_SHARE = 1 / 250.0;

  /** The sine of the angle between a patch and its triangles that is let pass: thin ones err. */
  private static final double MOST_TILT = 1e-3;

  /** Distance from the plane that is let pass, as a share of the mesh's size. */
  private static final double FLATNESS = 1e-5;

  private final float[] positions;
  private final int[] indices;
  private final double surface;
  private final double tolerance;
  private final List<FlatPart> parts = new ArrayList<>();
  private final double[] normal = new double[3];

  PatchFinder(Mesh mesh) {
    positions = mesh.positions();
    indices = mesh.indices();
    float[] box = mesh.bounds();
    double x = (double) box[3] - box[0];
    double y = (double) box[4] - box[1];
    double z = (double) box[5] - box[2];
    surface = 2 * (x * y + y * z + z * x);
    tolerance = FLATNESS * Math.max(x, Math.max(y, z)) + 0x1p-22 * Precision.reach(box);
  }

  /** The largest first. */
  List<Patch> find() {
    if (!(surface > 0) || surface == Double.POSITIVE_INFINITY) {
      return List.of();
    }
    runs();
    parts.sort(Comparator.comparingDouble((FlatPart part) -> -part.area));
    List<FlatPart> largest = parts.subList(0, Math.min(MOST_PATCHES, parts.size()));
    if (largest.isEmpty()) {
      return List.of();
    }
    collect(largest);
    List<Patch> patches = new ArrayList<>();
    for (FlatPart part : largest) {
      if (part.area >= PATCH_SHARE * surface) {
        Patch patch = part.patch();
        if (patch.edges().length > 0 && patch.edges().length <= 2 * MOST_EDGES) {
          patches.add(patch);
        }
      }
    }
    patches.sort(Comparator.comparingDouble(patch -> -patch.area()));
    return List.copyOf(patches);
  }

  private void runs() {
    FlatPart run = null;
    for (int i = 0; i < indices.length; i += 3) {
      double length = normal(i);
      if (length > 0) {
        if (run == null || !run.holds(i, normal, length)) {
          close(run);
          run = new FlatPart(positions, indices, i, normal, length, tolerance);
        }
        run.area += length / 2;
      }
    }
    close(run);
  }

  private void close(FlatPart run) {
    if (run == null || run.area < RUN_SHARE * surface) {
      return;
    }
    for (FlatPart part : parts) {
      if (part.samePlane(run)) {
        part.area += run.area;
        return;
      }
    }
    parts.add(run);
  }

  private void collect(List<FlatPart> into) {
    into.forEach(part -> part.area = 0);
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

  /** Triangles of one plane that face the same way. */
  private static final class FlatPart {
    private final float[] positions;
    private final int[] indices;
    private final double[] n = new double[3];
    private final double d;
    private final double tolerance;
    private final List<Integer> triangles = new ArrayList<>();
    private double area;
    private double tilt;

    FlatPart(
        float[] positions, int[] indices, int i, double[] normal, double length, double tolerance) {
      this.positions = positions;
      this.indices = indices;
      this.tolerance = tolerance;
      for (int axis = 0; axis < 3; axis++) {
        n[axis] = normal[axis] / length;
      }
      d = along(indices[i]);
    }

    private double along(int vertex) {
      return n[0] * positions[3 * vertex]
          + n[1] * positions[3 * vertex + 1]
          + n[2] * positions[3 * vertex + 2];
    }

    /** Whether a triangle with such a normal, of such a length, lies in the plane. */
    boolean holds(int i, double[] normal, double length) {
      double cosine = n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2];
      return cosine > 0.999 * length
          && Math.abs(along(indices[i]) - d) <= tolerance
          && Math.abs(along(indices[i + 1]) - d) <= tolerance
          && Math.abs(along(indices[i + 2]) - d) <= tolerance
          && sine(normal, length) <= MOST_TILT;
    }

    private double sine(double[] normal, double length) {
      double[] cross = new double[3];
      TriangleMath.cross(n[0], n[1], n[2], normal[0], normal[1], normal[2], cross);
      return TriangleMath.length(cross) / length;
    }

    boolean samePlane(FlatPart other) {
      return n[0] * other.n[0] + n[1] * other.n[1] + n[2] * other.n[2] > 1 - MOST_TILT * MOST_TILT
          && Math.abs(d - other.d) <= tolerance;
    }

    void add(int i, double[] normal, double length) {
      triangles.add(i);
      area += length / 2;
      tilt = Math.max(tilt, sine(normal, length));
    }

    Patch patch() {
      Outline outline = new Outline(positions);
      double thickness = 0;
      for (int i : triangles) {
        for (int corner = 0; corner < 3; corner++) {
          int v = indices[i + corner];
          thickness = Math.max(thickness, Math.abs(along(v) - d));
          outline.toggle(v, indices[i + (corner + 1) % 3]);
        }
      }
      return outline.patch(new double[] {n[0], n[1], n[2], d}, thickness, tilt, area);
    }
  }
}
