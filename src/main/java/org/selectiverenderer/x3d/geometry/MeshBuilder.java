package org.selectiverenderer.x3d.geometry;

import java.util.Arrays;

/** Collects the vertices and triangles of shapes whose formula gives every value. */
final class MeshBuilder {
  private float[] positions = new float[96];
  private float[] normals = new float[96];
  private float[] texCoords = new float[64];
  private int[] indices = new int[96];
  private int vertexCount;
  private int indexCount;

  /** Adds a vertex and returns its number. */
  int vertex(double x, double y, double z, double nx, double ny, double nz, double s, double t) {
    if (3 * vertexCount == positions.length) {
      positions = Arrays.copyOf(positions, 2 * positions.length);
      normals = Arrays.copyOf(normals, 2 * normals.length);
      texCoords = Arrays.copyOf(texCoords, 2 * texCoords.length);
    }
    int i = 3 * vertexCount;
    positions[i] = (float) x;
    positions[i + 1] = (float) y;
    positions[i + 2] = (float) z;
    normals[i] = (float) nx;
    normals[i + 1] = (float) ny;
    normals[i + 2] = (float) nz;
    texCoords[2 * vertexCount] = (float) s;
    texCoords[2 * vertexCount + 1] = (float) t;
    return vertexCount++;
  }

  /** Adds a triangle, counter-clockwise seen from its front. */
  void triangle(int a, int b, int c) {
    if (indexCount + 3 > indices.length) {
      indices = Arrays.copyOf(indices, 2 * indices.length);
    }
    indices[indexCount++] = a;
    indices[indexCount++] = b;
    indices[indexCount++] = c;
  }

  /** Adds the two triangles of a quadrilateral. */
  void quad(int a, int b, int c, int d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  Mesh mesh(boolean solid) {
    float[] finalPositions = Arrays.copyOf(positions, 3 * vertexCount);
    int[] finalIndices = Arrays.copyOf(indices, indexCount);
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        finalPositions,
        Arrays.copyOf(normals, 3 * vertexCount),
        null,
        Arrays.copyOf(texCoords, 2 * vertexCount),
        finalIndices,
        solid,
        Mesh.boundsOf(finalPositions, finalIndices));
  }

  /** A mesh without triangles. */
  static Mesh empty(boolean solid) {
    return new MeshBuilder().mesh(solid);
  }
}
