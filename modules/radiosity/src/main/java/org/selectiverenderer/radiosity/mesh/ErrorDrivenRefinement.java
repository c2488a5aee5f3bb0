package org.selectiverenderer.radiosity.mesh;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * Error-driven refinement: the facet with the largest interpolation error is divided next. The
 * error is the squared difference between interpolated corner colours and the samples of a {@link
 * FineMeshReference}, in shares of display white, integrated over the facet's area, times the
 * facet's size, since artefacts over a wall are more visible than those along a window's frame.
 */
final class ErrorDrivenRefinement {
  /** Error below which nothing is gained by division. */
  private static final double NONE = 1e-12;

  /**
   * @param error area-weighted sum of squared differences, times the facet's size
   * @param worst largest difference, as a share of white
   */
  private record Wish(ConformingTriangleMesh.Tile tile, double error, double worst) {}

  private final ConformingTriangleMesh mesh;
  private final FineMeshReference map;
  private final Map<ConformingTriangleMesh.Tile, List<FineMeshReference.Sample>> samples =
      new IdentityHashMap<>();
  private final PriorityQueue<Wish> queue =
      new PriorityQueue<>(
          Comparator.comparingDouble((Wish wish) -> -wish.error())
              .thenComparingInt(wish -> wish.tile().number));

  /**
   * @param roots the number of each facet in the map, by its number in the mesh
   */
  ErrorDrivenRefinement(
      ConformingTriangleMesh mesh, FineMeshReference map, Map<Integer, Integer> roots) {
    this.mesh = mesh;
    this.map = map;
    for (ConformingTriangleMesh.Tile tile : mesh.tiles()) {
      samples.put(tile, map.of(roots.get(tile.number)));
      queue.add(wish(tile));
    }
  }

  /**
   * Divides facets until their number is reached or none is worth it.
   *
   * @param polygons the number of facets to reach
   * @param shortest facets without an edge longer than this, metres, are not divided, nor are those
   *     with no more area than half a square with this diagonal: strips need no finer light than
   *     planes
   * @param threshold facets whose largest difference does not exceed this share of white are not
   *     divided
   */
  void divide(int polygons, double shortest, double threshold) {
    while (!queue.isEmpty() && mesh.count() < polygons) {
      Wish wish = queue.poll();
      if (wish.error() < NONE) {
        return;
      }
      boolean worth = wish.worst() > threshold && large(wish.tile(), shortest);
      if (!worth || !mesh.alive(wish.tile())) {
        continue;
      }
      ConformingTriangleMesh.Edge edge = mesh.terminal(wish.tile());
      if (mesh.count() + mesh.cost(edge) > polygons || !mesh.sound(edge)) {
        continue;
      }
      halve(edge);
      if (mesh.alive(wish.tile())) {
        queue.add(wish); // Only a neighbour has been divided so far.
      }
    }
  }

  private boolean large(ConformingTriangleMesh.Tile tile, double shortest) {
    double area = tile.plane[3] / 2;
    return area > shortest * shortest / 4 && mesh.length(mesh.longest(tile)) > shortest;
  }

  private void halve(ConformingTriangleMesh.Edge edge) {
    List<ConformingTriangleMesh.Tile> parents = List.copyOf(mesh.at(edge));
    List<ConformingTriangleMesh.Tile> made = mesh.halve(edge);
    for (int k = 0; k < parents.size(); k++) {
      List<FineMeshReference.Sample> all = samples.remove(parents.get(k));
      ConformingTriangleMesh.Tile one = made.get(2 * k);
      ConformingTriangleMesh.Tile two = made.get(2 * k + 1);
      Map<Boolean, List<FineMeshReference.Sample>> sides = new HashMap<>();
      double[] first = new double[3];
      double[] second = new double[3];
      for (FineMeshReference.Sample sample : all) {
        weights(one, sample, first);
        weights(two, sample, second);
        boolean inFirst = least(first) >= least(second);
        sides.computeIfAbsent(inFirst, key -> new ArrayList<>()).add(sample);
      }
      samples.put(one, sides.getOrDefault(true, List.of()));
      samples.put(two, sides.getOrDefault(false, List.of()));
      queue.add(wish(one));
      queue.add(wish(two));
    }
  }

  private Wish wish(ConformingTriangleMesh.Tile tile) {
    double[] values = new double[3];
    for (int i = 0; i < 3; i++) {
      values[i] = map.corner(tile, i, mesh.value(tile.points[i]));
    }
    double[] w = new double[3];
    double error = 0;
    double worst = 0;
    for (FineMeshReference.Sample sample : samples.get(tile)) {
      weights(tile, sample, w);
      double off = w[0] * values[0] + w[1] * values[1] + w[2] * values[2] - sample.value();
      error += sample.area() * off * off;
      worst = Math.max(worst, Math.abs(off));
    }
    return new Wish(tile, error * Math.sqrt(tile.plane[3]), worst);
  }

  private static double least(double[] weights) {
    return Math.min(weights[0], Math.min(weights[1], weights[2]));
  }

  /** Computes the barycentric weights of a facet's corners at a point in its plane. */
  private static void weights(
      ConformingTriangleMesh.Tile tile, FineMeshReference.Sample at, double[] out) {
    float[] c = tile.facet.corners();
    for (int i = 0; i < 3; i++) {
      int j = 3 * ((i + 1) % 3);
      int k = 3 * ((i + 2) % 3);
      double[] n = tile.plane;
      double doubled =
          TriangleMath.triple(
              n,
              c[k] - c[j],
              c[k + 1] - c[j + 1],
              c[k + 2] - c[j + 2],
              at.x() - c[j],
              at.y() - c[j + 1],
              at.z() - c[j + 2]);
      out[i] = n[3] > 0 ? doubled / n[3] : 1.0 / 3;
    }
  }
}
