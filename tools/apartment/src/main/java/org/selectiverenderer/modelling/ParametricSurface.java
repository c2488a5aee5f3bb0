package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.MeshMeasures;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/** Builds surfaces given by a function: {@code 2 columns rows} triangles, with a border. */
public final class ParametricSurface {

  private ParametricSurface() {}

  /** The height of a height field at x and z. */
  @FunctionalInterface
  public interface Height {
    double at(double x, double z);
  }

  /** A point of the surface; u and v go from 0 to 1. */
  @FunctionalInterface
  public interface Place {
    Vector3d at(double u, double v);
  }

  /** Returns a height field about the origin that faces up. */
  public static TriangleMesh field(
      double width, double depth, int columns, int rows, Height height) {
    return of(
        columns,
        rows,
        (u, v) -> {
          double x = (u - 0.5) * width;
          double z = (0.5 - v) * depth;
          return new Vector3d(x, height.at(x, z), z);
        });
  }

  /** Returns a parametric surface; it faces the viewer for whom u goes right and v goes up. */
  public static TriangleMesh of(int columns, int rows, Place place) {
    List<Vector3d[]> points = new ArrayList<>();
    for (int r = 0; r <= rows; r++) {
      Vector3d[] row = new Vector3d[columns + 1];
      for (int c = 0; c <= columns; c++) {
        row[c] = place.at((double) c / columns, (double) r / rows);
      }
      points.add(row);
    }
    return LoftedSurface.over(points, LoftedSurface.Form.SHEET);
  }

  /**
   * Returns a closed solid of a sheet and its copy moved by a vector, with walls along the border:
   * {@code 2 t + 2 b} triangles for t triangles of the sheet and b edges of its border.
   */
  public static TriangleMesh thicken(TriangleMesh sheet, double x, double y, double z) {
    int points = sheet.pointCount();
    TriangleMeshBuilder mesh = new TriangleMeshBuilder();
    for (int i = 0; i < points; i++) {
      mesh.point(sheet.point(i));
    }
    for (int i = 0; i < points; i++) {
      mesh.point(sheet.point(i).add(x, y, z));
    }
    int[] t = sheet.triangles();
    for (int i = 0; i < t.length; i += 3) {
      mesh.triangle(t[i], t[i + 1], t[i + 2]);
      mesh.triangle(points + t[i], points + t[i + 2], points + t[i + 1]);
    }
    for (int[] edge : MeshMeasures.border(sheet)) {
      mesh.quad(edge[1], edge[0], points + edge[0], points + edge[1]);
    }
    return mesh.mesh().outward();
  }
}
