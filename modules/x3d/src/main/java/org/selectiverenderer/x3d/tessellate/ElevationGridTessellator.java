package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Tessellates ElevationGridTessellator nodes (X3D 4.0, 13.3.4): heights over the x-z plane. */
final class ElevationGridTessellator {
  private ElevationGridTessellator() {}

  static Mesh mesh(TessellationContext job) {
    NodeView node = job.node();
    int columns = node.integer("xDimension");
    int rows = node.integer("zDimension");
    float[] heights = node.floats("height");
    boolean solid = node.bool("solid");
    if (columns < 2 || rows < 2 || !job.positive("xSpacing", "zSpacing")) {
      return PrimitiveMeshBuilder.empty(solid);
    }
    if (tooFew(job, heights.length, columns, rows)) {
      return PrimitiveMeshBuilder.empty(solid);
    }
    double xSpacing = node.number("xSpacing");
    double zSpacing = node.number("zSpacing");
    float[] xyz = new float[3 * columns * rows];
    for (int row = 0, point = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++, point++) {
        xyz[3 * point] = (float) (column * xSpacing);
        xyz[3 * point + 1] = heights[point];
        xyz[3 * point + 2] = (float) (row * zSpacing);
      }
    }
    return mesh(job, xyz, columns, rows, false, job.node().number("creaseAngle"));
  }

  /** Returns whether there are fewer heights than points, and reports it. */
  static boolean tooFew(TessellationContext job, int heights, int columns, int rows) {
    if (heights >= (long) columns * rows) {
      return false;
    }
    job.problem(
        "has %d heights for %d x %d points; it is left out".formatted(heights, columns, rows));
    return true;
  }

  private static VertexAttribute texCoords(int columns, int rows) {
    float[] texCoords = new float[2 * columns * rows];
    for (int point = 0; point < columns * rows; point++) {
      texCoords[2 * point] = (float) (point % columns) / (columns - 1);
      texCoords[2 * point + 1] = (float) (point / columns) / (rows - 1);
    }
    return new VertexAttribute(texCoords, 2, null);
  }

  /**
   * Returns the faces between the points of a grid, which with ccw face upwards.
   *
   * @param northwards whether the second row lies north of the first rather than south
   */
  static Mesh mesh(
      TessellationContext job,
      float[] xyz,
      int columns,
      int rows,
      boolean northwards,
      double creaseAngle) {
    CoordinatePoints points = CoordinatePoints.of(xyz);
    int quads = (columns - 1) * (rows - 1);
    int[] stream = new int[4 * quads];
    TriangleListBuilder triangles = new TriangleListBuilder(stream, 2 * quads);
    FaceValidator check = new FaceValidator(stream, points, 3);
    for (int quad = 0; quad < quads; quad++) {
      int at = 4 * quad;
      int corner = quad / (columns - 1) * columns + quad % (columns - 1);
      stream[at] = corner;
      stream[at + 1] = northwards ? corner + 1 : corner + columns;
      stream[at + 2] = corner + columns + 1;
      stream[at + 3] = northwards ? corner + columns : corner + 1;
      if (check.accepts(at, at + 4)) {
        triangles.add(at, at + 1, at + 2, quad);
        triangles.add(at, at + 2, at + 3, quad);
      }
    }
    check.report(job, "face");
    return new ComposedGeometryMesher(job, points, triangles, quads)
        .composed(ComposedGeometryMesher.Indices.NONE, creaseAngle, texCoords(columns, rows));
  }
}
