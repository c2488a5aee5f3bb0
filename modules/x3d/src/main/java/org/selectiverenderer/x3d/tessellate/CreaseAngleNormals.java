package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;

/**
 * Generates normals by crease angle (X3D 4.0, 11.2.3): at each point, faces that share an edge with
 * a dihedral angle below the crease angle form a smoothing group, and the group's normal is the sum
 * of its face normals weighted by their angles at the point. Takes time linear in the number of
 * corners, however many of them meet at one point.
 */
final class CreaseAngleNormals {
  /** The maximum number of faces compared per edge; only non-manifold edges have more than two. */
  private static final int FACES_PER_EDGE = 16;

  /** Opposite faces are never smoothed, at any crease angle, as their normals would cancel out. */
  private static final float BACK_TO_BACK = -0.99999f;

  private final int pointCount;
  private final int[] corners;
  private final int[] faces;
  private final float[] faceNormals;
  private final float[] angles;
  private final float cosine;

  private final int[] ids;
  private float[] normals;
  private int normalCount;

  // Corners sorted by point: those of point p are atPoint[start[p]] up to start[p + 1].
  private final int[] start;
  private final int[] atPoint;

  // For the current point, indexed by the position of a corner among the point's corners.
  private final int[] parent;
  private final int[] groupNormal;
  private final float[] sums;

  // Edges of the current point: the corners beside the edge to q are a linked list from head[q].
  private final int[] edgeOwner;
  private final int[] head;
  private final int[] next;

  CreaseAngleNormals(
      int pointCount,
      int[] corners,
      int[] faces,
      float[] faceNormals,
      float[] angles,
      double creaseAngle) {
    this.pointCount = pointCount;
    this.corners = corners;
    this.faces = faces;
    this.faceNormals = faceNormals;
    this.angles = angles;
    this.cosine =
        creaseAngle >= Math.PI
            ? BACK_TO_BACK
            : Math.max(BACK_TO_BACK, (float) Math.cos(creaseAngle));
    this.ids = new int[corners.length];
    this.normals = new float[3 * Math.max(16, Math.min(pointCount, corners.length))];
    this.start = new int[pointCount + 1];
    this.atPoint = new int[corners.length];
    int valence = sortByPoint();
    this.parent = new int[valence];
    this.groupNormal = new int[valence];
    this.sums = new float[3 * valence];
    this.next = new int[2 * valence];
    this.head = new int[pointCount];
    this.edgeOwner = new int[pointCount];
    Arrays.fill(edgeOwner, -1);
  }

  /** Returns the normal of each corner. */
  VertexAttribute attribute() {
    for (int point = 0; point < pointCount; point++) {
      int from = start[point];
      int to = start[point + 1];
      if (from < to) {
        group(point, from, to);
        sum(from, to);
        assign(from, to);
      }
    }
    return new VertexAttribute(normals, 3, ids);
  }

  /**
   * Fills {@link #start} and {@link #atPoint}; returns the maximum number of corners at a point.
   */
  private int sortByPoint() {
    for (int point : corners) {
      start[point]++;
    }
    int valence = 0;
    int end = 0;
    for (int point = 0; point < pointCount; point++) {
      valence = Math.max(valence, start[point]);
      end += start[point];
      start[point] = end;
    }
    start[pointCount] = end;
    for (int corner = corners.length - 1; corner >= 0; corner--) {
      atPoint[--start[corners[corner]]] = corner;
    }
    return valence;
  }

  private void group(int point, int from, int to) {
    for (int i = 0; i < to - from; i++) {
      parent[i] = i;
      int corner = atPoint[from + i];
      int triangle = corner / 3;
      int first = 3 * triangle;
      int place = corner - first;
      visitEdge(point, from, i, triangle, corners[first + (place == 2 ? 0 : place + 1)], 2 * i);
      visitEdge(point, from, i, triangle, corners[first + (place == 0 ? 2 : place - 1)], 2 * i + 1);
    }
  }

  /** Unites a corner with earlier ones at the edge from {@code point} to {@code other}. */
  private void visitEdge(int point, int from, int i, int triangle, int other, int entry) {
    int previous = -1;
    if (edgeOwner[other] == point) {
      previous = head[other];
      int tries = FACES_PER_EDGE;
      for (int e = previous; e >= 0 && tries > 0; e = next[e], tries--) {
        int a = root(i);
        int b = root(e >> 1);
        if (a != b && smooth(faces[triangle], faces[atPoint[from + (e >> 1)] / 3])) {
          parent[Math.max(a, b)] = Math.min(a, b);
        }
      }
    } else {
      edgeOwner[other] = point;
    }
    next[entry] = previous;
    head[other] = entry;
  }

  private boolean smooth(int face, int other) {
    int f = 3 * face;
    int o = 3 * other;
    return face == other
        || faceNormals[f] * faceNormals[o]
                + faceNormals[f + 1] * faceNormals[o + 1]
                + faceNormals[f + 2] * faceNormals[o + 2]
            > cosine;
  }

  private int root(int i) {
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  private void sum(int from, int to) {
    Arrays.fill(sums, 0, 3 * (to - from), 0);
    Arrays.fill(groupNormal, 0, to - from, -1);
    for (int i = 0; i < to - from; i++) {
      int corner = atPoint[from + i];
      int f = 3 * faces[corner / 3];
      int group = 3 * root(i);
      float weight = angles[corner];
      sums[group] += weight * faceNormals[f];
      sums[group + 1] += weight * faceNormals[f + 1];
      sums[group + 2] += weight * faceNormals[f + 2];
    }
  }

  private void assign(int from, int to) {
    for (int i = 0; i < to - from; i++) {
      int group = root(i);
      int corner = atPoint[from + i];
      if (groupNormal[group] < 0) {
        float x = sums[3 * group];
        float y = sums[3 * group + 1];
        float z = sums[3 * group + 2];
        float length = (float) Math.sqrt(x * x + y * y + z * z);
        if (length < 1e-6f) {
          int f = 3 * faces[corner / 3];
          ids[corner] = add(faceNormals[f], faceNormals[f + 1], faceNormals[f + 2]);
          continue;
        }
        groupNormal[group] = add(x / length, y / length, z / length);
      }
      ids[corner] = groupNormal[group];
    }
  }

  private int add(float x, float y, float z) {
    if (3 * normalCount + 3 > normals.length) {
      normals = Arrays.copyOf(normals, 2 * normals.length);
    }
    normals[3 * normalCount] = x;
    normals[3 * normalCount + 1] = y;
    normals[3 * normalCount + 2] = z;
    return normalCount++;
  }
}
