package org.selectiverenderer.modelling;

import java.util.Arrays;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.LongestEdgeBisection;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** The vertices of a mesh whose edges are split, with a growing list of positions. */
final class EdgeSplitVertexBuffer implements LongestEdgeBisection.Vertices {
  private float[] positions;
  private int count;

  EdgeSplitVertexBuffer(TriangleMesh mesh) {
    positions = mesh.positions().clone();
    count = mesh.pointCount();
  }

  @Override
  public int point(int vertex) {
    return vertex;
  }

  @Override
  public double square(int a, int b) {
    return Vector3d.distanceSquared(
        positions[3 * a],
        positions[3 * a + 1],
        positions[3 * a + 2],
        positions[3 * b],
        positions[3 * b + 1],
        positions[3 * b + 2]);
  }

  @Override
  public int middle(int a, int b, int point) {
    if (3 * count + 3 > positions.length) {
      positions = Arrays.copyOf(positions, 2 * positions.length);
    }
    for (int k = 0; k < 3; k++) {
      positions[3 * count + k] =
          (float) (((double) positions[3 * a + k] + positions[3 * b + k]) / 2);
    }
    return count++;
  }

  float[] positions() {
    return Arrays.copyOf(positions, 3 * count);
  }
}
