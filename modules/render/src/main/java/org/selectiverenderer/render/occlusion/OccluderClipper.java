package org.selectiverenderer.render.occlusion;

import org.joml.Matrix4dc;

/**
 * Transforms an occluder's outline to an eye's coordinates and clips it at a near plane. Reuses its
 * arrays.
 */
final class OccluderClipper {
  /** The corners in the eye's coordinates: right, up, away. */
  private double[] points = new double[96];

  /** The points where the outline was clipped: right and up at depth 1. */
  private double[] cuts = new double[24];

  private int cutCount;
  private double nearest;

  /**
   * @param nearest the depth of the clipping plane; what is left has this depth or more
   * @return whether anything is left
   */
  boolean clip(OccluderPolygon patch, Matrix4dc toEye, double newNearest) {
    nearest = newNearest;
    double[] p = patch.points();
    if (points.length < p.length) {
      points = new double[2 * p.length];
    }
    boolean any = false;
    for (int i = 0; i < p.length; i += 3) {
      double x = p[i];
      double y = p[i + 1];
      double z = p[i + 2];
      points[i] = toEye.m00() * x + toEye.m10() * y + toEye.m20() * z + toEye.m30();
      points[i + 1] = toEye.m01() * x + toEye.m11() * y + toEye.m21() * z + toEye.m31();
      points[i + 2] = -(toEye.m02() * x + toEye.m12() * y + toEye.m22() * z + toEye.m32());
      any |= points[i + 2] >= newNearest;
    }
    return any;
  }

  /**
   * Rasterises the edges of the clipped outline; view directions map to cells by scale and origin.
   */
  void edges(
      OccluderPolygon patch,
      OcclusionBuffer grid,
      double scaleX,
      double scaleY,
      double originX,
      double originY) {
    cutCount = 0;
    int[] pairs = patch.edges();
    for (int i = 0; i < pairs.length; i += 2) {
      int a = 3 * pairs[i];
      int b = 3 * pairs[i + 1];
      boolean aKept = points[a + 2] >= nearest;
      boolean bKept = points[b + 2] >= nearest;
      if (!aKept && !bKept) {
        continue;
      }
      double ax = points[a] / points[a + 2];
      double ay = points[a + 1] / points[a + 2];
      double bx = points[b] / points[b + 2];
      double by = points[b + 1] / points[b + 2];
      if (!aKept) {
        int cut = cut(b, a);
        ax = cuts[cut];
        ay = cuts[cut + 1];
      } else if (!bKept) {
        int cut = cut(a, b);
        bx = cuts[cut];
        by = cuts[cut + 1];
      }
      grid.edge(
          ax * scaleX + originX,
          ay * scaleY + originY,
          bx * scaleX + originX,
          by * scaleY + originY);
    }
    close(grid, scaleX, scaleY, originX, originY);
  }

  /**
   * Clips an edge that crosses the near plane; returns the place of the new point in {@code cuts}.
   */
  private int cut(int kept, int lost) {
    if (cuts.length < 2 * cutCount + 2) {
      cuts = java.util.Arrays.copyOf(cuts, 2 * cuts.length);
    }
    double share = (points[kept + 2] - nearest) / (points[kept + 2] - points[lost + 2]);
    int at = 2 * cutCount++;
    cuts[at] = (points[kept] + share * (points[lost] - points[kept])) / nearest;
    cuts[at + 1] = (points[kept + 1] + share * (points[lost + 1] - points[kept + 1])) / nearest;
    return at;
  }

  /**
   * Closes the clipped outline. The clip points lie on a line that enters or leaves the polygon at
   * each of them: the first to the second, the third to the fourth and so on are edges of the
   * clipped polygon.
   */
  private void close(
      OcclusionBuffer grid, double scaleX, double scaleY, double originX, double originY) {
    if (cutCount == 0) {
      return;
    }
    int axis = wider();
    // Insertion sort, as there are few.
    for (int i = 2; i < 2 * cutCount; i += 2) {
      for (int j = i; j > 0 && cuts[j - 2 + axis] > cuts[j + axis]; j -= 2) {
        swap(j, j - 2);
        swap(j + 1, j - 1);
      }
    }
    for (int i = 0; i + 3 < 2 * cutCount; i += 4) {
      grid.edge(
          cuts[i] * scaleX + originX,
          cuts[i + 1] * scaleY + originY,
          cuts[i + 2] * scaleX + originX,
          cuts[i + 3] * scaleY + originY);
    }
  }

  /** Returns the axis along which the clip points spread farther. */
  private int wider() {
    double[] min = {cuts[0], cuts[1]};
    double[] max = {cuts[0], cuts[1]};
    for (int i = 2; i < 2 * cutCount; i++) {
      min[i % 2] = Math.min(min[i % 2], cuts[i]);
      max[i % 2] = Math.max(max[i % 2], cuts[i]);
    }
    return max[0] - min[0] >= max[1] - min[1] ? 0 : 1;
  }

  private void swap(int a, int b) {
    double kept = cuts[a];
    cuts[a] = cuts[b];
    cuts[b] = kept;
  }
}
