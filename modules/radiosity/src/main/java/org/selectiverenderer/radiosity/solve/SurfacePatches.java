package org.selectiverenderer.radiosity.solve;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * The surfaces of a scene divided into patches of about one size. A large triangle is divided into
 * equal triangles; small triangles of a body that lie in the same grid cube and face the same side
 * form one patch. A two-sided surface has two patches, the one of its back with the next number.
 * Immutable; for several threads.
 */
public final class SurfacePatches {
  /** Largest number of parts that an edge is divided into. */
  private static final int MOST_PARTS = 100;

  private final RadiosityScene scene;

  /** Per triangle: the number of its first area. An area is a patch without regard to its side. */
  private final int[] areaOf;

  /** Per triangle: the number of parts of an edge; 0 if the triangle shares an area with others. */
  private final int[] parts;

  // Per area: the patch of its front, its triangles, the part of the triangle that it is if there
  // is only one, and its size.
  private final int[] frontOf;
  private final int[][] members;
  private final int[] cell;
  private final double[] size;

  // Per patch.
  private final int[] areaOfPatch;
  private final boolean[] back;

  private record Cube(int x, int y, int z, int side) {}

  /**
   * @param length side of a patch, metres
   */
  public SurfacePatches(RadiosityScene scene, double length) {
    this.scene = scene;
    int triangles = scene.triangles().count();
    areaOf = new int[triangles];
    parts = new int[triangles];
    List<int[]> memberLists = new ArrayList<>();
    List<Integer> cells = new ArrayList<>();
    for (Body body : scene.bodies()) {
      divide(body, length, memberLists, cells);
    }
    int areas = memberLists.size();
    members = memberLists.toArray(int[][]::new);
    cell = cells.stream().mapToInt(Integer::intValue).toArray();
    size = new double[areas];
    frontOf = new int[areas];
    int patches = 0;
    double[] normal = new double[3];
    for (int i = 0; i < areas; i++) {
      frontOf[i] = patches;
      patches += twoSided(i) ? 2 : 1;
      for (int triangle : members[i]) {
        double n = Math.max(1, parts[triangle]);
        size[i] += scene.triangles().normal(triangle, normal) / (n * n);
      }
    }
    areaOfPatch = new int[patches];
    back = new boolean[patches];
    for (int i = 0; i < areas; i++) {
      areaOfPatch[frontOf[i]] = i;
      if (twoSided(i)) {
        areaOfPatch[frontOf[i] + 1] = i;
        back[frontOf[i] + 1] = true;
      }
    }
  }

  private boolean twoSided(int area) {
    return scene.triangles().twoSided()[members[area][0]];
  }

  private void divide(Body body, double length, List<int[]> memberLists, List<Integer> cells) {
    Map<Cube, List<Integer>> cubes = new HashMap<>();
    List<Cube> order = new ArrayList<>();
    double[] normal = new double[3];
    for (int i = 0; i < body.triangles(); i++) {
      int triangle = body.firstTriangle() + i;
      double edge = longestEdge(triangle);
      double area = scene.triangles().normal(triangle, normal);
      int n = (int) Math.min(MOST_PARTS, Math.ceil(edge / length));
      // Fewer parts for long slivers.
      n = (int) Math.min(n, Math.ceil(Math.sqrt(4 * area / (length * length))) + 1);
      if (edge > 1.5 * length && n > 1) {
        areaOf[triangle] = memberLists.size();
        parts[triangle] = n;
        for (int part = 0; part < n * n; part++) {
          memberLists.add(new int[] {triangle});
          cells.add(part);
        }
      } else {
        Cube cube = cube(triangle, normal, length);
        cubes
            .computeIfAbsent(
                cube,
                key -> {
                  order.add(key);
                  return new ArrayList<>();
                })
            .add(triangle);
      }
    }
    for (Cube cube : order) {
      int[] all = cubes.get(cube).stream().mapToInt(Integer::intValue).toArray();
      for (int triangle : all) {
        areaOf[triangle] = memberLists.size();
      }
      memberLists.add(all);
      cells.add(0);
    }
  }

  private Cube cube(int triangle, double[] normal, double length) {
    double[] centre = new double[3];
    scene.triangles().point(triangle, 1 / 3.0, 1 / 3.0, centre);
    int axis = 0;
    for (int i = 1; i < 3; i++) {
      if (Math.abs(normal[i]) > Math.abs(normal[axis])) {
        axis = i;
      }
    }
    return new Cube(
        (int) Math.floor(centre[0] / length),
        (int) Math.floor(centre[1] / length),
        (int) Math.floor(centre[2] / length),
        2 * axis + (normal[axis] < 0 ? 1 : 0));
  }

  private double longestEdge(int triangle) {
    float[] c = scene.triangles().corners();
    double longest = 0;
    for (int i = 0; i < 3; i++) {
      int a = 9 * triangle + 3 * i;
      int b = 9 * triangle + 3 * ((i + 1) % 3);
      double x = c[a] - c[b];
      double y = c[a + 1] - c[b + 1];
      double z = c[a + 2] - c[b + 2];
      longest = Math.max(longest, x * x + y * y + z * z);
    }
    return Math.sqrt(longest);
  }

  /** Returns the number of patches. */
  public int count() {
    return areaOfPatch.length;
  }

  /** Returns the area of a patch, square metres. */
  public double area(int patch) {
    return size[areaOfPatch[patch]];
  }

  /** Returns one triangle of a patch; all triangles of a patch belong to one body. */
  public int triangle(int patch) {
    return members[areaOfPatch[patch]][0];
  }

  /**
   * Returns the patch at a point of a triangle.
   *
   * @param u barycentric weight of the second corner
   * @param v barycentric weight of the third corner
   */
  public int at(int triangle, double u, double v, boolean behind) {
    int n = parts[triangle];
    int area = areaOf[triangle];
    if (n > 0) {
      int row = Math.max(0, Math.min(n - 1, (int) (v * n)));
      double along = u * n;
      int column = Math.max(0, Math.min(n - 1 - row, (int) along));
      boolean upper = along - column + (v * n - row) > 1 && column < n - 1 - row;
      area += 2 * n * row - row * row + 2 * column + (upper ? 1 : 0);
    }
    int front = frontOf[area];
    return behind && twoSided(area) ? front + 1 : front;
  }

  /**
   * Samples a point of a patch uniformly.
   *
   * @param pick from 0 to 1: chooses the triangle
   * @param s from 0 to 1; with {@code t} it chooses the point in the triangle
   * @param point receives x, y, z
   * @param normal receives the unit normal on the patch's side
   * @return the triangle
   */
  public int place(int patch, double pick, double s, double t, double[] point, double[] normal) {
    int area = areaOfPatch[patch];
    int[] all = members[area];
    int triangle = all.length == 1 ? all[0] : pick(all, pick * size[area], normal);
    double root = Math.sqrt(s);
    double u = root * (1 - t);
    double v = root * t;
    int n = parts[triangle];
    if (n > 0) {
      int part = cell[area];
      int row = 0;
      while (part >= 2 * (n - row) - 1) {
        part -= 2 * (n - row) - 1;
        row++;
      }
      int column = part / 2;
      if (part % 2 == 1) {
        u = (column + 1 - u) / n;
        v = (row + 1 - v) / n;
      } else {
        u = (column + u) / n;
        v = (row + v) / n;
      }
    }
    scene.triangles().normal(triangle, normal);
    scene.triangles().point(triangle, u, v, point);
    if (back[patch]) {
      for (int i = 0; i < 3; i++) {
        normal[i] = -normal[i];
      }
    }
    return triangle;
  }

  private int pick(int[] all, double wanted, double[] normal) {
    double sum = 0;
    for (int triangle : all) {
      sum += scene.triangles().normal(triangle, normal);
      if (sum >= wanted) {
        return triangle;
      }
    }
    return all[all.length - 1];
  }
}
