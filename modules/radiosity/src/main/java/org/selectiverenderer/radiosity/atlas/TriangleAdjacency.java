package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.VertexWelder;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * The triangles of a body with their adjacency. Vertices at the same position are welded, whatever
 * their normals. Triangles are neighbours where their half-edges run in opposite directions, as on
 * the two sides of an edge of an oriented surface; where more than two triangles meet at an edge,
 * the flattest pair are neighbours.
 */
final class TriangleAdjacency {
  static final int NONE = -1;

  /** Number of triangles at one edge beyond which none of them are neighbours there. */
  private static final int CROWD = 16;

  /** Height of a triangle by its longest edge below which its normal is not reliable. */
  private static final double THIN = 1e-6;

  private final float[] corners;
  private final int first;
  private final int[] vertices;
  private final int[] neighbours;
  private final float[] normals;
  private final double[] areas;

  TriangleAdjacency(RadiosityScene scene, Body body) {
    corners = scene.triangles().corners();
    first = 9 * body.firstTriangle();
    int count = body.triangles();
    VertexWelder welder =
        new VertexWelder(body.positions().length / 3, body.positions(), null, null, null);
    welder.weld();
    vertices = new int[3 * count];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = welder.numbers()[body.vertex(i / 3, i % 3)];
    }
    normals = new float[3 * count];
    areas = new double[count];
    measure();
    neighbours = new int[3 * count];
    link();
  }

  int triangles() {
    return areas.length;
  }

  double area(int triangle) {
    return areas[triangle];
  }

  /** Returns whether a triangle is so thin that it has no reliable normal. */
  boolean thin(int triangle) {
    int at = 3 * triangle;
    return normals[at] == 0 && normals[at + 1] == 0 && normals[at + 2] == 0;
  }

  /** Returns a component of a triangle's unit normal; 0 for a thin triangle. */
  float normal(int triangle, int axis) {
    return normals[3 * triangle + axis];
  }

  /** Returns the cosine of the angle between the normals of two triangles; 1 if one is thin. */
  double facing(int a, int b) {
    if (thin(a) || thin(b)) {
      return 1;
    }
    int i = 3 * a;
    int j = 3 * b;
    return (double) normals[i] * normals[j]
        + (double) normals[i + 1] * normals[j + 1]
        + (double) normals[i + 2] * normals[j + 2];
  }

  /**
   * Returns the cosine of the angle between a triangle's normal and a direction; 1 for a thin
   * triangle.
   */
  double facing(int triangle, double x, double y, double z) {
    int i = 3 * triangle;
    return thin(triangle) ? 1 : normals[i] * x + normals[i + 1] * y + normals[i + 2] * z;
  }

  /** Returns the welded vertex at a corner, 0 to 2. */
  int vertex(int triangle, int corner) {
    return vertices[3 * triangle + corner];
  }

  double coordinate(int triangle, int corner, int axis) {
    return corners[first + 9 * triangle + 3 * corner + axis];
  }

  /** Returns the triangle across the edge from a corner to the next, or {@link #NONE}. */
  int neighbour(int triangle, int edge) {
    int half = neighbours[3 * triangle + edge];
    return half < 0 ? NONE : half / 3;
  }

  double edgeLength(int triangle, int edge) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double d = coordinate(triangle, (edge + 1) % 3, axis) - coordinate(triangle, edge, axis);
      sum += d * d;
    }
    return Math.sqrt(sum);
  }

  private void measure() {
    double[] normal = new double[3];
    for (int i = 0; i < areas.length; i++) {
      int at = first + 9 * i;
      TriangleMath.normal(corners, at, at + 3, at + 6, normal);
      double twice = TriangleMath.normalize(normal);
      double longest = Math.max(edgeLength(i, 0), Math.max(edgeLength(i, 1), edgeLength(i, 2)));
      areas[i] = twice / 2;
      if (twice > THIN * longest * longest) {
        for (int axis = 0; axis < 3; axis++) {
          normals[3 * i + axis] = (float) normal[axis];
        }
      }
    }
  }

  /** Finds the opposite half-edge of every half-edge by a hash table of edges. */
  private void link() {
    int halves = vertices.length;
    int[] table = new int[Integer.highestOneBit(Math.max(8, halves)) * 2];
    int[] same = new int[halves];
    int mask = table.length - 1;
    int[] heads = new int[halves];
    for (int half = 0; half < halves; half++) {
      int slot = hash(half) & mask;
      while (table[slot] != 0 && !sameEdge(table[slot] - 1, half)) {
        slot = (slot + 1) & mask;
      }
      heads[half] = slot;
      same[half] = table[slot] - 1;
      table[slot] = half + 1;
    }
    for (int half = 0; half < halves; half++) {
      heads[half] = table[heads[half]] - 1;
    }
    Arrays.fill(neighbours, NONE);
    for (int half = 0; half < halves; half++) {
      neighbours[half] = flattest(half, heads[half], same);
    }
    // Neighbours must be mutual: where three sheets meet at an edge, the third has no neighbour
    // there.
    for (int half = 0; half < halves; half++) {
      int other = neighbours[half];
      if (other >= 0 && neighbours[other] != half) {
        neighbours[half] = NONE;
      }
    }
  }

  private int flattest(int half, int head, int[] same) {
    if (from(half) == to(half)) {
      return NONE;
    }
    int best = NONE;
    double flat = -2;
    int steps = 0;
    for (int other = head; other >= 0; other = same[other]) {
      if (++steps > CROWD) {
        return NONE;
      }
      if (from(other) == to(half) && other / 3 != half / 3) {
        double facing = facing(half / 3, other / 3);
        // The list runs from the last to the first; of equally flat pairs the first is taken.
        if (facing >= flat) {
          flat = facing;
          best = other;
        }
      }
    }
    return best;
  }

  private int from(int half) {
    return vertices[half];
  }

  private int to(int half) {
    return vertices[half % 3 == 2 ? half - 2 : half + 1];
  }

  private boolean sameEdge(int a, int b) {
    return from(a) == from(b) && to(a) == to(b) || from(a) == to(b) && to(a) == from(b);
  }

  private int hash(int half) {
    int a = Math.min(from(half), to(half));
    int b = Math.max(from(half), to(half));
    int hash = (a * 0x9E3779B1 ^ b) * 0x85EBCA6B;
    return hash ^ hash >>> 15;
  }
}
