package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/** Builds boxes that stand on y = 0, centred on x and z. */
public final class BoxBuilder {

  private BoxBuilder() {}

  /** Returns a box with sharp edges, 12 triangles. */
  public static TriangleMesh plain(double width, double height, double depth) {
    return ExtrudedSolid.plain(depth, SimplePolygon.rectangle(width, height))
        .move(0, height / 2, -depth / 2);
  }

  /**
   * Returns a box with all edges and corners rounded: {@code 8 (steps+1) (2 steps+1) + 4 - 8 steps}
   * triangles, that is 44, 108, 204, 332 for 1 (a chamfer), 2, 3, 4 steps.
   *
   * @param radius bevel radius, metres; at most half the shortest side
   */
  public static TriangleMesh bevelled(
      double width, double height, double depth, double radius, int steps) {
    if (2 * radius > Math.min(width, Math.min(height, depth)) + 1e-9) {
      throw new IllegalArgumentException(
          "the bevel radius of a box must be at most half its shortest side");
    }
    List<Vector3d[]> rows = new ArrayList<>();
    for (int half = 0; half < 2; half++) {
      for (int step = 0; step <= steps; step++) {
        double latitude = half == 0 ? 90.0 * step / steps - 90 : 90.0 * step / steps;
        double centre = half == 0 ? radius : height - radius;
        rows.add(
            row(
                width / 2 - radius,
                depth / 2 - radius,
                radius * DegreeMath.cos(latitude),
                centre + radius * DegreeMath.sin(latitude),
                steps));
      }
    }
    TriangleMesh sides = LoftedSurface.over(rows, LoftedSurface.Form.PIPE);
    TriangleMeshBuilder ends = new TriangleMeshBuilder();
    end(ends, rows.get(0), steps + 1, true);
    end(ends, rows.get(rows.size() - 1), steps + 1, false);
    return VertexWelding.weld(sides.append(ends.mesh())).outward();
  }

  /**
   * Returns the points of one level of the box: four quarter circles about the corners of the flat
   * rectangle.
   */
  private static Vector3d[] row(double x, double z, double radius, double y, int steps) {
    Vector3d[] row = new Vector3d[4 * (steps + 1)];
    for (int corner = 0; corner < 4; corner++) {
      double cx = corner == 0 || corner == 3 ? x : -x;
      double cz = corner < 2 ? -z : z;
      for (int step = 0; step <= steps; step++) {
        double angle = 90 * corner + 90.0 * step / steps;
        row[corner * (steps + 1) + step] =
            new Vector3d(
                cx + radius * DegreeMath.cos(angle), y, cz - radius * DegreeMath.sin(angle));
      }
    }
    return row;
  }

  private static void end(TriangleMeshBuilder mesh, Vector3d[] row, int perCorner, boolean below) {
    int[] corner = new int[4];
    for (int i = 0; i < 4; i++) {
      corner[i] = mesh.point(row[i * perCorner]);
    }
    if (below) {
      mesh.quad(corner[3], corner[2], corner[1], corner[0]);
    } else {
      mesh.quad(corner[0], corner[1], corner[2], corner[3]);
    }
  }
}
