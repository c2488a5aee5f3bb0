package org.selectiverenderer.radiosity.mesh;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.function.ToDoubleFunction;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Adaptive subdivision of the surfaces of a region: first down to the maximum mesh size, then where
 * light changes most, to an exact number of facets (thesis 5.2.1, Figs 60 and 61).
 */
public final class AdaptiveSubdivision {
  /** Share of the facets to be added that may go into reaching the maximum mesh size. */
  private static final double FOR_SIZE = 0.3;

  /** Surfaces displayed darker than this share of white are not divided. */
  private static final double DARK = 0.02;

  private final ConformingTriangleMesh mesh;
  private final int polygons;
  private final double minMesh;
  private final double maxMesh;
  private final List<Integer> bodies;

  /** In a copy: the number of each facet by that of the facet that it copies. */
  private final Map<Integer, Integer> origins = new HashMap<>();

  /**
   * @param bodies numbers of the region's bodies in the scene
   * @param polygons the number of facets to reach
   */
  public AdaptiveSubdivision(
      RadiosityScene scene, List<Integer> bodies, int polygons, double minMesh, double maxMesh) {
    this(new ConformingTriangleMesh(scene.extent()), bodies, polygons, minMesh, maxMesh);
    for (int number : bodies) {
      Body body = scene.bodies().get(number);
      for (int i = 0; i < body.triangles(); i++) {
        mesh.add(number, Facet.of(body, i));
      }
    }
  }

  private AdaptiveSubdivision(
      ConformingTriangleMesh mesh,
      List<Integer> bodies,
      int polygons,
      double minMesh,
      double maxMesh) {
    this.mesh = mesh;
    this.bodies = bodies;
    this.polygons = polygons;
    this.minMesh = minMesh;
    this.maxMesh = maxMesh;
  }

  /** Returns a copy that is divided independently, up to another number of facets. */
  public AdaptiveSubdivision copy(int limit) {
    AdaptiveSubdivision copy =
        new AdaptiveSubdivision(mesh.empty(), bodies, limit, minMesh, maxMesh);
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      ConformingTriangleMesh.Tile same = copy.mesh.add(tile.body, tile.facet);
      copy.origins.put(tile.number, same.number);
      for (int i = 0; i < 3; i++) {
        copy.mesh.value(same.points[i], mesh.value(tile.points[i]));
      }
    }
    return copy;
  }

  /** Returns the present number of facets. */
  public int count() {
    return mesh.count();
  }

  /**
   * Removes T-junctions: divides edges on which corners of other facets lie, as far as the number
   * of polygons allows.
   */
  public void join() {
    joinTJunctions(polygons);
  }

  /**
   * Divides lit facets down to the maximum mesh size; dark ones, such as outsides of walls, are
   * left.
   */
  public void toSize() {
    int limit = count() + (int) (FOR_SIZE * (polygons - count()));
    divide(limit, edge -> lit(edge) && mesh.length(edge) > maxMesh ? mesh.length(edge) : -1);
  }

  private boolean lit(ConformingTriangleMesh.Edge edge) {
    return mesh.value(edge.a()) > DARK || mesh.value(edge.b()) > DARK;
  }

  /**
   * Divides lit facets down to twice the minimum mesh size, or as far as the number allows, so that
   * the errors of a coarser mesh can be measured on the result.
   */
  public void toFinest() {
    divide(polygons, edge -> lit(edge) && mesh.length(edge) > 2 * minMesh ? mesh.length(edge) : -1);
  }

  /**
   * Divides where the interpolation error is largest.
   *
   * @param finer a finer division of a {@link #copy} of this one
   * @param light the light on the finer division, by body and facet, three shares of white each
   * @param threshold error, as a share of white, up to which a facet is not divided
   */
  public void toLight(AdaptiveSubdivision finer, Map<Integer, double[]> light, double threshold) {
    new ErrorDrivenRefinement(mesh, finer.map(light), finer.origins)
        .divide(polygons, 2 * minMesh, threshold);
  }

  private FineMeshReference map(Map<Integer, double[]> light) {
    FineMeshReference map = new FineMeshReference();
    Map<Integer, Integer> next = new HashMap<>();
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      if (!mesh.flat(tile)) {
        int at = next.merge(tile.body, 1, Integer::sum) - 1;
        map.add(tile, light.get(tile.body), 3 * at);
      }
    }
    return map;
  }

  /** Divides the longest edges first, as far as the number of polygons allows. */
  public void toLength() {
    divide(polygons, mesh::length);
  }

  /**
   * Divides to the exact number of facets, longest edges first.
   *
   * @return whether the number is reached: a closed surface has an even number of facets
   */
  public boolean toNumber() {
    while (count() < polygons) {
      int missing = polygons - count();
      var edge = mesh.longestOfCost(Math.min(2, missing));
      if (edge.isEmpty() || missing == 1 && mesh.cost(edge.get()) != 1) {
        return false;
      }
      mesh.halve(edge.get());
    }
    return count() == polygons;
  }

  private void divide(int limit, ToDoubleFunction<ConformingTriangleMesh.Edge> worth) {
    record Wish(ConformingTriangleMesh.Tile tile, double worth) {}
    PriorityQueue<Wish> queue =
        new PriorityQueue<>(
            Comparator.comparingDouble((Wish wish) -> -wish.worth())
                .thenComparingInt(wish -> wish.tile().number));
    ToDoubleFunction<ConformingTriangleMesh.Tile> best =
        tile ->
            Math.max(
                worth.applyAsDouble(tile.edge(0)),
                Math.max(worth.applyAsDouble(tile.edge(1)), worth.applyAsDouble(tile.edge(2))));
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      queue.add(new Wish(tile, best.applyAsDouble(tile)));
    }
    while (!queue.isEmpty() && count() < limit) {
      Wish wish = queue.poll();
      if (wish.worth() <= 0) {
        return;
      }
      if (!mesh.alive(wish.tile())) {
        continue;
      }
      ConformingTriangleMesh.Edge edge = mesh.terminal(wish.tile());
      if (count() + mesh.cost(edge) > polygons || !mesh.sound(edge)) {
        continue;
      }
      for (ConformingTriangleMesh.Tile made : mesh.halve(edge)) {
        queue.add(new Wish(made, best.applyAsDouble(made)));
      }
      if (mesh.alive(wish.tile())) {
        queue.add(wish); // Only a neighbour was divided so far.
      }
    }
  }

  /** Divides edges at corners of other facets that lie on them. */
  private void joinTJunctions(int limit) {
    boolean again = true;
    while (again) {
      again = false;
      Map<Long, List<Spot>> cells = cells();
      List<ConformingTriangleMesh.Edge> edges = mesh.edges();
      edges.sort(
          Comparator.comparingInt(ConformingTriangleMesh.Edge::a)
              .thenComparingInt(ConformingTriangleMesh.Edge::b));
      for (ConformingTriangleMesh.Edge edge : edges) {
        if (mesh.at(edge).isEmpty() || !mesh.sound(edge) || mesh.length(edge) < 2 * minMesh) {
          continue;
        }
        if (count() + mesh.cost(edge) > limit) {
          return;
        }
        int point = on(edge, cells);
        if (point >= 0) {
          float[] a = mesh.place(edge.a());
          float[] p = mesh.place(point);
          double way = Math.sqrt(square(a, p));
          mesh.divide(edge, p, (float) (way / mesh.length(edge)));
          again = true;
        }
      }
    }
  }

  private static final double CELL = 0.25;

  /** A corner of a facet and the facet's plane. */
  private record Spot(int point, double[] plane) {}

  private Map<Long, List<Spot>> cells() {
    Map<Long, List<Spot>> cells = new HashMap<>();
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      for (int point : tile.points) {
        float[] p = mesh.place(point);
        cells
            .computeIfAbsent(key(p[0], p[1], p[2]), key -> new ArrayList<>())
            .add(new Spot(point, tile.plane));
      }
    }
    return cells;
  }

  private static long key(double x, double y, double z) {
    long i = (long) Math.floor(x / CELL) & 0x1fffff;
    long j = (long) Math.floor(y / CELL) & 0x1fffff;
    long k = (long) Math.floor(z / CELL) & 0x1fffff;
    return i << 42 | j << 21 | k;
  }

  /**
   * Returns a point that lies on an edge and is a corner of a facet in the plane of a facet at the
   * edge, or -1.
   */
  private int on(ConformingTriangleMesh.Edge edge, Map<Long, List<Spot>> cells) {
    float[] a = mesh.place(edge.a());
    float[] b = mesh.place(edge.b());
    double length = mesh.length(edge);
    int steps = (int) Math.min(4000, Math.ceil(length / (CELL / 2)));
    long last = Long.MIN_VALUE;
    for (int step = 0; step <= steps; step++) {
      double t = steps == 0 ? 0 : (double) step / steps;
      long key = key(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]));
      if (key == last) {
        continue;
      }
      last = key;
      for (Spot spot : cells.getOrDefault(key, List.of())) {
        if (inside(mesh.place(spot.point()), a, b, length)
            && !touches(edge, spot.point())
            && mesh.at(edge).stream().anyMatch(tile -> tile.alike(spot.plane()))) {
          return spot.point();
        }
      }
    }
    return -1;
  }

  /**
   * Returns whether a point is a corner of a facet at the edge: a degenerate facet must not be cut.
   */
  private boolean touches(ConformingTriangleMesh.Edge edge, int point) {
    for (ConformingTriangleMesh.Tile tile : mesh.at(edge)) {
      for (int corner : tile.points) {
        if (corner == point) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean inside(float[] p, float[] a, float[] b, double length) {
    double along = 0;
    for (int axis = 0; axis < 3; axis++) {
      along += (p[axis] - a[axis]) * (b[axis] - a[axis]) / length;
    }
    double off = square(a, p) - along * along;
    return along > 1e-3 && along < length - 1e-3 && off < 1e-8;
  }

  private static double square(float[] a, float[] b) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double d = (double) a[axis] - b[axis];
      sum += d * d;
    }
    return sum;
  }

  /** Returns the facets by body, degenerate ones left out. */
  public Map<Integer, List<Facet>> facets() {
    Map<Integer, List<Facet>> all = new HashMap<>();
    bodies.forEach(body -> all.put(body, new ArrayList<>()));
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      if (!mesh.flat(tile)) {
        all.get(tile.body).add(tile.facet);
      }
    }
    return all;
  }

  /**
   * Sets the light at the points: the value of a point is the mean over the facet corners there.
   *
   * @param light by body and facet in the order of {@link #facets}, three shares of white each
   */
  public void light(Map<Integer, double[]> light) {
    double[] sums = new double[mesh.pointCount()];
    int[] counts = new int[mesh.pointCount()];
    Map<Integer, Integer> next = new HashMap<>();
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      if (mesh.flat(tile)) {
        continue;
      }
      int at = next.merge(tile.body, 1, Integer::sum) - 1;
      for (int i = 0; i < 3; i++) {
        sums[tile.points[i]] += light.get(tile.body)[3 * at + i];
        counts[tile.points[i]]++;
      }
    }
    for (int point = 0; point < sums.length; point++) {
      if (counts[point] > 0) {
        mesh.value(point, sums[point] / counts[point]);
      }
    }
  }
}
