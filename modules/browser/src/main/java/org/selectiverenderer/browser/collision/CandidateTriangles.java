package org.selectiverenderer.browser.collision;

import java.util.Arrays;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The candidate triangles near the viewer, each with the mesh that it belongs to; collected again
 * for every movement step.
 */
public final class CandidateTriangles {
  private double[] coordinates = new double[9 * 64];
  private PlacedMesh[] owners = new PlacedMesh[64];
  private int size;

  void clear() {
    size = 0;
  }

  int size() {
    return size;
  }

  void add(Vector3dc a, Vector3dc b, Vector3dc c, PlacedMesh owner) {
    if (size == owners.length) {
      coordinates = Arrays.copyOf(coordinates, 2 * coordinates.length);
      owners = Arrays.copyOf(owners, 2 * size);
    }
    put(9 * size, a);
    put(9 * size + 3, b);
    put(9 * size + 6, c);
    owners[size++] = owner;
  }

  private void put(int at, Vector3dc p) {
    coordinates[at] = p.x();
    coordinates[at + 1] = p.y();
    coordinates[at + 2] = p.z();
  }

  /** Writes a corner (0, 1 or 2) of a triangle to {@code out} and returns it. */
  Vector3d corner(int triangle, int corner, Vector3d out) {
    int at = 9 * triangle + 3 * corner;
    return out.set(coordinates[at], coordinates[at + 1], coordinates[at + 2]);
  }

  PlacedMesh owner(int triangle) {
    return owners[triangle];
  }
}
