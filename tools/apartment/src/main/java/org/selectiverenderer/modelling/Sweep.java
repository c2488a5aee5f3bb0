package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * Builds sections swept along a {@link Spine}: handles, rails, cables, frames. At an open spine's
 * start the section's y is up (towards -z where the spine itself goes up or down), seen by a viewer
 * who looks along the spine. Corners are mitred. An open spine of n points gives {@code 2 (n - 1)
 * size} triangles and {@code size} for each end; a closed one {@code 2 n size}.
 */
public final class Sweep {

  private Sweep() {}

  /** Returns a sweep with a constant section; the ends of an open spine are closed. */
  public static TriangleMesh of(SimplePolygon section, Spine spine) {
    return of(section, spine, t -> 1);
  }

  /**
   * @param scale scale of the section as a function of the share of the spine's points passed, 0 to
   *     1; 0 at an end makes a tip
   */
  public static TriangleMesh of(SimplePolygon section, Spine spine, DoubleUnaryOperator scale) {
    List<Vector3d[]> rows = new ArrayList<>();
    RotationMinimizingFrames frames = new RotationMinimizingFrames(spine);
    int n = spine.points().size();
    for (int i = 0; i < n; i++) {
      double factor = scale.applyAsDouble(n == 1 ? 0 : (double) i / (n - 1));
      Vector3d[] row = new Vector3d[section.size()];
      for (int k = 0; k < row.length; k++) {
        row[k] = frames.place(i, factor * section.x(k), factor * section.y(k));
      }
      rows.add(row);
    }
    return LoftedSurface.over(
        rows, spine.closed() ? LoftedSurface.Form.RING : LoftedSurface.Form.CAPPED);
  }

  /** Returns a round tube with closed ends. */
  public static TriangleMesh tube(Spine spine, double radius, int segments) {
    return of(SimplePolygon.circle(radius, segments), spine);
  }

  /** Returns a round tube whose radius changes from point to point of the spine. */
  public static TriangleMesh tube(Spine spine, int segments, DoubleUnaryOperator radius) {
    return of(SimplePolygon.circle(1, segments), spine, radius);
  }
}
