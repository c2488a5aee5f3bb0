package org.selectiverenderer.runtime.collision;

import java.util.Random;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Meshes made by hand. */
public final class TestMeshes {
  private TestMeshes() {}

  public static Mesh of(float[] positions, int[] indices, boolean solid, float... texCoords) {
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        null,
        null,
        texCoords.length == 0 ? null : texCoords,
        indices,
        solid,
        Mesh.boundsOf(positions, indices));
  }

  /** A box between two corners, wound to be seen from outside. */
  public static Mesh box(double x0, double y0, double z0, double x1, double y1, double z1) {
    float[] p = new float[24];
    for (int i = 0; i < 8; i++) {
      p[3 * i] = (float) ((i & 1) == 0 ? x0 : x1);
      p[3 * i + 1] = (float) ((i & 2) == 0 ? y0 : y1);
      p[3 * i + 2] = (float) ((i & 4) == 0 ? z0 : z1);
    }
    int[] faces = {
      0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2,
      6, 7, 2, 7, 3
    };
    return of(p, faces, true);
  }

  /** Four corners in order round the face, seen from where that is counter-clockwise. */
  public static Mesh quad(boolean solid, double... corners) {
    float[] p = new float[12];
    for (int i = 0; i < 12; i++) {
      p[i] = (float) corners[i];
    }
    return of(p, new int[] {0, 1, 2, 0, 2, 3}, solid, 0, 0, 1, 0, 1, 1, 0, 1);
  }

  /** A level square about the origin. */
  public static Mesh floor(double y, double half) {
    return quad(true, -half, y, half, half, y, half, half, y, -half, -half, y, -half);
  }

  /** A unit sphere of {@code n} by {@code 2n} faces. */
  public static Mesh sphere(int n) {
    float[] p = new float[3 * (n + 1) * 2 * n];
    int at = 0;
    for (int i = 0; i <= n; i++) {
      for (int j = 0; j < 2 * n; j++) {
        double down = Math.PI * i / n;
        double about = Math.PI * j / n;
        p[at++] = (float) (Math.sin(down) * Math.sin(about));
        p[at++] = (float) Math.cos(down);
        p[at++] = (float) (Math.sin(down) * Math.cos(about));
      }
    }
    int[] indices = new int[12 * n * n];
    at = 0;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < 2 * n; j++) {
        int a = 2 * n * i + j;
        int b = 2 * n * i + (j + 1) % (2 * n);
        for (int corner : new int[] {a, a + 2 * n, b + 2 * n, a, b + 2 * n, b}) {
          indices[at++] = corner;
        }
      }
    }
    return of(p, indices, true);
  }

  /** Small triangles strewn in a cube of edge 20, among them some without area. */
  public static Mesh soup(int triangles, Random random) {
    float[] p = new float[9 * triangles];
    int[] indices = new int[3 * triangles];
    for (int i = 0; i < triangles; i++) {
      for (int corner = 0; corner < 3; corner++) {
        for (int axis = 0; axis < 3; axis++) {
          float centre = corner == 0 ? random.nextFloat() * 20 - 10 : p[9 * i + axis];
          float spread = corner == 0 || i % 50 == 0 ? 0 : random.nextFloat() * 2 - 1;
          p[9 * i + 3 * corner + axis] = centre + spread;
        }
        indices[3 * i + corner] = 3 * i + corner;
      }
    }
    return of(p, indices, false);
  }
}
