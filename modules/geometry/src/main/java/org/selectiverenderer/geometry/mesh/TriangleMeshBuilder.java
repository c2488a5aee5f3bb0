package org.selectiverenderer.geometry.mesh;

import java.util.Arrays;
import org.joml.Vector3dc;

/** Builds a triangle mesh point by point. */
public final class TriangleMeshBuilder {
  private float[] positions = new float[96];
  private int[] triangles = new int[96];
  private int points;
  private int corners;

  /** Adds a point and returns its index. */
  public int point(double x, double y, double z) {
    if (3 * points + 3 > positions.length) {
      positions = Arrays.copyOf(positions, 2 * positions.length);
    }
    positions[3 * points] = (float) x;
    positions[3 * points + 1] = (float) y;
    positions[3 * points + 2] = (float) z;
    return points++;
  }

  /** Adds a point and returns its index, for a vector. */
  public int point(Vector3dc p) {
    return point(p.x(), p.y(), p.z());
  }

  /** Adds a triangle, counter-clockwise seen from its front. */
  public void triangle(int a, int b, int c) {
    if (corners + 3 > triangles.length) {
      triangles = Arrays.copyOf(triangles, 2 * triangles.length);
    }
    triangles[corners++] = a;
    triangles[corners++] = b;
    triangles[corners++] = c;
  }

  /** Adds the quadrilateral a, b, c, d, split along its diagonal from a to c. */
  public void quad(int a, int b, int c, int d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  /** Returns the mesh. */
  public TriangleMesh mesh() {
    return new TriangleMesh(
        Arrays.copyOf(positions, 3 * points), Arrays.copyOf(triangles, corners));
  }
}
