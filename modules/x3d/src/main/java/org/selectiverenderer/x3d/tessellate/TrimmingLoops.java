package org.selectiverenderer.x3d.tessellate;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Reads the trimming loops of a NURBS surface (X3D 4.0, 27.4.1) as polygons in u and v. */
final class TrimmingLoops {
  /** A surface whose trimming contours have more points than this is drawn untrimmed. */
  private static final int MAX_POINTS = 20_000;

  private TrimmingLoops() {}

  /**
   * Returns each Contour2D as one polygon, the concatenation of its curves.
   *
   * @return u, v per point, the end not repeated
   */
  static List<double[]> of(List<? extends NodeView> contours, TessellationContext job) {
    List<double[]> polygons = new ArrayList<>();
    int total = 0;
    for (NodeView contour : contours) {
      if (!contour.type().name().equals("Contour2D")) {
        continue;
      }
      List<Double> values = new ArrayList<>();
      for (NodeView curve : contour.nodes("children")) {
        for (double value : NurbsNodeReader.polyline(curve, job::problem)) {
          values.add(value);
        }
      }
      double[] polygon = distinct(values);
      total += polygon.length / 2;
      if (polygon.length < 6) {
        job.problem("has a trimming contour with fewer than 3 points; it is left out");
      } else {
        polygons.add(polygon);
      }
    }
    if (total > MAX_POINTS) {
      job.problem(
          "has trimming contours of more than " + MAX_POINTS + " points; it is not trimmed");
      return List.of();
    }
    return polygons;
  }

  /** Removes points that repeat the previous one, as where one curve meets the next. */
  private static double[] distinct(List<Double> values) {
    double[] kept = new double[values.size()];
    int count = 0;
    for (int i = 0; i + 1 < values.size(); i += 2) {
      double u = values.get(i);
      double v = values.get(i + 1);
      boolean finite = Double.isFinite(u) && Double.isFinite(v);
      if (finite && (count == 0 || !near(u, v, kept[count - 2], kept[count - 1]))) {
        kept[count++] = u;
        kept[count++] = v;
      }
    }
    if (count > 2 && near(kept[0], kept[1], kept[count - 2], kept[count - 1])) {
      count -= 2;
    }
    return java.util.Arrays.copyOf(kept, count);
  }

  private static boolean near(double u, double v, double otherU, double otherV) {
    return Math.abs(u - otherU) + Math.abs(v - otherV) < 1e-9;
  }
}
