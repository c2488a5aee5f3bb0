package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * Snaps models to the grid on which {@link X3dModelWriter} writes them, so that the counted
 * triangles are those in the file: points in one grid cell are merged and triangles that become
 * degenerate are removed.
 */
public final class GridSnapping {

  private GridSnapping() {}

  /** Returns the model as its file will hold it; parts that vanish are left out. */
  public static ParametricModel toGrid(ParametricModel model) {
    int decimals = X3dModelWriter.decimals(model.bounds());
    double unit = DecimalFormatter.unit(decimals);
    List<Part> parts = new ArrayList<>();
    for (Part part : model.parts()) {
      TriangleMesh mesh = toGrid(part.mesh(), unit);
      if (mesh.triangleCount() > 0) {
        parts.add(part.with(mesh));
      }
    }
    return new ParametricModel(model.name(), parts);
  }

  private static TriangleMesh toGrid(TriangleMesh mesh, double unit) {
    long[] cells = new long[mesh.positions().length];
    float[] rounded = new float[cells.length];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = cell(mesh.positions()[i], unit);
      rounded[i] = (float) (cells[i] / unit);
    }
    int[] t = mesh.triangles();
    int[] kept = new int[t.length];
    int corners = 0;
    for (int i = 0; i < t.length; i += 3) {
      if (hasArea(cells, 3 * t[i], 3 * t[i + 1], 3 * t[i + 2])) {
        System.arraycopy(t, i, kept, corners, 3);
        corners += 3;
      }
    }
    return corners == t.length
        ? new TriangleMesh(rounded, t)
        : VertexWelding.weld(new TriangleMesh(rounded, Arrays.copyOf(kept, corners)), 0.5 / unit);
  }

  /**
   * Returns the grid cell of a coordinate, rounded half away from zero so that mirrored models stay
   * mirrored.
   */
  static long cell(double coordinate, double unit) {
    long cell = Math.round(Math.abs(coordinate) * unit);
    return coordinate < 0 ? -cell : cell;
  }

  private static boolean hasArea(long[] p, int a, int b, int c) {
    long ux = p[b] - p[a];
    long uy = p[b + 1] - p[a + 1];
    long uz = p[b + 2] - p[a + 2];
    long vx = p[c] - p[a];
    long vy = p[c + 1] - p[a + 1];
    long vz = p[c + 2] - p[a + 2];
    return uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx;
  }
}
