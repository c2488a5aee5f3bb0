package org.selectiverenderer.radiosity.trace;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * What rays meet in a scene. For what has no versions and for the reference version of each object
 * it is the scene with all references; for any other version that object's reference is replaced by
 * the version itself. So every version is lit in its own place and none shadows another of the same
 * object. Immutable; for several threads.
 */
public final class Visibility {
  private final TriangleTree all;
  private final TriangleTree[] own;
  private final int[] objectOf;

  /** By version: the tree that its triangles are in; 0 is the one that all rays meet. */
  private final int[] treeOf;

  public Visibility(SceneTriangles triangles, Versions versions) {
    objectOf = IntStream.range(0, versions.count()).map(versions::object).toArray();
    treeOf =
        IntStream.range(0, objectOf.length).map(v -> versions.isReference(v) ? 0 : v).toArray();
    int[][] members = new int[versions.count()][];
    int[] sizes = new int[versions.count()];
    for (int version : triangles.version()) {
      sizes[treeOf[version]]++;
    }
    for (int i = 0; i < sizes.length; i++) {
      members[i] = new int[sizes[i]];
    }
    Arrays.fill(sizes, 0);
    for (int i = 0; i < triangles.count(); i++) {
      int tree = treeOf[triangles.version()[i]];
      members[tree][sizes[tree]++] = i;
    }
    TriangleTree[] trees = new TriangleTree[members.length];
    IntStream.range(0, members.length)
        .parallel()
        .forEach(
            i -> {
              if (i == 0 || members[i].length > 0) {
                trees[i] = new TriangleTree(triangles, members[i], objectOf);
              }
            });
    all = trees[0];
    own = trees;
  }

  /**
   * Finds what a ray meets first; {@code ray.triangle} is {@link Ray#NOTHING} if that is nothing.
   *
   * @param version the version of an object that the ray leaves from
   */
  public void nearest(Ray ray, int version) {
    ray.cast++;
    ray.triangle = Ray.NOTHING;
    if (treeOf[version] == 0) {
      all.nearest(ray, 0);
    } else {
      own[version].nearest(ray, 0);
      all.nearest(ray, objectOf[version]);
    }
  }

  /** The share of light that passes along a ray up to its length. */
  public double transmittance(Ray ray, int version) {
    ray.cast++;
    ray.triangle = Ray.NOTHING;
    double pass = ray.pass;
    ray.pass = 2; // Every triangle is met; what it lets through is multiplied.
    double light;
    if (treeOf[version] == 0) {
      light = all.transmittance(ray, 0);
    } else {
      light = own[version].transmittance(ray, 0);
      if (light > 0) {
        light *= all.transmittance(ray, objectOf[version]);
      }
    }
    ray.pass = pass;
    return light;
  }
}
