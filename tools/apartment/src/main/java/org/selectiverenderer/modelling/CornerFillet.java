package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.geometry.DegreeMath;

/** Rounds the corners of polylines in the plane (fillets). */
final class CornerFillet {

  private CornerFillet() {}

  /**
   * Replaces each corner by an arc; the first and last point of an open line stay.
   *
   * @param xy x, y per point
   * @param radius radius of the arcs, metres; smaller where an edge is too short for it
   * @param steps number of segments per arc
   */
  static double[] round(double[] xy, boolean closed, double radius, int steps) {
    int n = xy.length / 2;
    List<double[]> out = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      double[] p = {xy[2 * i], xy[2 * i + 1]};
      if (!closed && (i == 0 || i == n - 1)) {
        out.add(p);
      } else {
        int before = (i + n - 1) % n;
        int after = (i + 1) % n;
        arc(
            new double[] {xy[2 * before] - p[0], xy[2 * before + 1] - p[1]},
            p,
            new double[] {xy[2 * after] - p[0], xy[2 * after + 1] - p[1]},
            radius,
            steps,
            out);
      }
    }
    return out.stream().flatMapToDouble(Arrays::stream).toArray();
  }

  private static void arc(
      double[] u, double[] p, double[] v, double radius, int steps, List<double[]> out) {
    double lengthU = Math.sqrt(u[0] * u[0] + u[1] * u[1]);
    double lengthV = Math.sqrt(v[0] * v[0] + v[1] * v[1]);
    double turn = DegreeMath.atan2(-u[0] * v[1] + u[1] * v[0], -u[0] * v[0] - u[1] * v[1]);
    double tangent = Math.abs(DegreeMath.sin(turn / 2) / DegreeMath.cos(turn / 2));
    if (tangent < 1e-9) {
      out.add(p);
      return;
    }
    double reach = Math.min(radius * tangent, 0.5 * Math.min(lengthU, lengthV));
    double r = Math.copySign(reach / tangent, turn);
    double startX = p[0] + u[0] / lengthU * reach;
    double startY = p[1] + u[1] / lengthU * reach;
    double centreX = startX + r * u[1] / lengthU;
    double centreY = startY - r * u[0] / lengthU;
    for (int i = 0; i <= steps; i++) {
      double s = DegreeMath.sin(turn * i / steps);
      double c = DegreeMath.cos(turn * i / steps);
      double dx = startX - centreX;
      double dy = startY - centreY;
      add(out, centreX + c * dx - s * dy, centreY + s * dx + c * dy);
    }
  }

  /**
   * Adds a point unless it repeats the last one, as where two arcs use up the edge between them.
   */
  private static void add(List<double[]> out, double x, double y) {
    double[] last = out.isEmpty() ? null : out.get(out.size() - 1);
    if (last == null || Math.abs(last[0] - x) + Math.abs(last[1] - y) > 1e-9) {
      out.add(new double[] {x, y});
    }
  }
}
