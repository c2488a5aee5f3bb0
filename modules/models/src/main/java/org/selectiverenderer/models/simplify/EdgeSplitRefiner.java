package org.selectiverenderer.models.simplify;

import java.util.Arrays;
import org.selectiverenderer.geometry.mesh.LongestEdgeBisection;

/**
 * Adds polygons by edge splits without changing the shape, to meet a given count. Normals, colours
 * and texture coordinates of a new vertex are the means of its neighbours'.
 */
final class EdgeSplitRefiner implements LongestEdgeBisection.Vertices {
  private final double scale;
  private float[] vertices;
  private int[] origins;
  private int[] points;
  private int vertexCount;

  private EdgeSplitRefiner(MergedMesh mesh, double scale) {
    this.scale = scale;
    vertices = mesh.vertices().clone();
    origins = mesh.origins().clone();
    points = PositionRemap.first(mesh, false);
    vertexCount = mesh.vertexCount();
  }

  /**
   * Returns the same shape with that many polygons, or one less where the surface is closed and an
   * odd number is missing.
   *
   * @param scale steps per unit of length of the grid that positions are rounded to
   */
  static MergedMesh upTo(int polygons, MergedMesh mesh, double scale) {
    EdgeSplitRefiner vertices = new EdgeSplitRefiner(mesh, scale);
    LongestEdgeBisection splitter = new LongestEdgeBisection(vertices, mesh.indices());
    int missing = polygons - splitter.triangles();
    while (missing > 0 && splitter.split(missing) > 0) {
      missing = polygons - splitter.triangles();
    }
    return vertices.mesh(splitter.indices());
  }

  /**
   * Returns the same shape with that many more positions, each of which adds one or two polygons.
   */
  static MergedMesh withMore(int positions, MergedMesh mesh, double scale) {
    EdgeSplitRefiner vertices = new EdgeSplitRefiner(mesh, scale);
    LongestEdgeBisection splitter = new LongestEdgeBisection(vertices, mesh.indices());
    int added = 0;
    while (added < positions && splitter.split(2) > 0) {
      added++;
    }
    return vertices.mesh(splitter.indices());
  }

  private MergedMesh mesh(int[] indices) {
    return new MergedMesh(
        Arrays.copyOf(vertices, MergedMesh.STRIDE * vertexCount),
        indices,
        Arrays.copyOf(origins, vertexCount));
  }

  @Override
  public int point(int vertex) {
    return points[vertex];
  }

  @Override
  public double square(int a, int b) {
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      double side =
          (double) vertices[MergedMesh.STRIDE * a + axis] - vertices[MergedMesh.STRIDE * b + axis];
      square += side * side;
    }
    return square;
  }

  @Override
  public int middle(int a, int b, int point) {
    if (vertexCount == origins.length) {
      int larger = 2 * vertexCount + 1;
      vertices = Arrays.copyOf(vertices, MergedMesh.STRIDE * larger);
      origins = Arrays.copyOf(origins, larger);
      points = Arrays.copyOf(points, larger);
    }
    int to = MergedMesh.STRIDE * vertexCount;
    for (int i = 0; i < MergedMesh.STRIDE; i++) {
      double mean =
          ((double) vertices[MergedMesh.STRIDE * a + i] + vertices[MergedMesh.STRIDE * b + i]) / 2;
      vertices[to + i] = (float) (i < 3 ? Math.rint(mean * scale) / scale : mean) + 0.0f;
    }
    vertices[to + MergedMesh.PART] = vertices[MergedMesh.STRIDE * a + MergedMesh.PART];
    origins[vertexCount] = origins[a];
    points[vertexCount] = point < 0 ? vertexCount : point;
    return vertexCount++;
  }
}
