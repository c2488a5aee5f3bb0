package org.selectiverenderer.radiosity.mesh;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reference light of a region, sampled on a fine mesh, against which the interpolation error of a
 * coarser mesh is measured: shares of display white at the centroids of the fine facets, grouped by
 * the coarse facet that they are parts of, and at their corners.
 */
final class FineMeshReference {
  /** Key of a corner shared by facets of one plane. */
  private record Spot(long place, long plane) {}

  /**
   * The light at one sample point.
   *
   * @param area the area that the sample stands for, square metres, times its weight
   */
  record Sample(double x, double y, double z, double value, double area) {}

  private static final double LEVEL = 0.7;
  private static final double UP = 10;
  private static final double DOWN = 0.4;

  private final Map<Integer, List<Sample>> samples = new HashMap<>();
  private final Map<Spot, Double> corners = new HashMap<>();

  /**
   * @param values shares of white at the three corners, from {@code at} on
   */
  void add(ConformingTriangleMesh.Tile tile, double[] values, int at) {
    float[] c = tile.facet.corners();
    double mean = (values[at] + values[at + 1] + values[at + 2]) / 3;
    samples
        .computeIfAbsent(tile.root, key -> new java.util.ArrayList<>())
        .add(
            new Sample(
                (c[0] + c[3] + c[6]) / 3.0,
                (c[1] + c[4] + c[7]) / 3.0,
                (c[2] + c[5] + c[8]) / 3.0,
                mean,
                weight(tile) * tile.plane[3] / 2));
    for (int i = 0; i < 3; i++) {
      corners.put(spot(tile, i), values[at + i]);
    }
  }

  /**
   * Returns the weight of a facet: surfaces that face up carry the shadows of the things that stand
   * on them, and few people look at a ceiling.
   */
  private static double weight(ConformingTriangleMesh.Tile tile) {
    double up = tile.plane[1];
    return up > LEVEL ? UP : up < -LEVEL ? DOWN : 1;
  }

  /** Returns the samples inside of a facet as it was before any division. */
  List<Sample> of(int root) {
    return samples.getOrDefault(root, List.of());
  }

  /** Returns the light at a corner, or {@code otherwise} if it is not known. */
  double corner(ConformingTriangleMesh.Tile tile, int corner, double otherwise) {
    return corners.getOrDefault(spot(tile, corner), otherwise);
  }

  private static Spot spot(ConformingTriangleMesh.Tile tile, int corner) {
    long plane = 0;
    for (int axis = 0; axis < 3; axis++) {
      plane = plane << 9 | Math.round(tile.plane[axis] * 100) + 128;
    }
    return new Spot(RadiosityMesh.place(tile.facet.corners(), 3 * corner), plane);
  }
}
