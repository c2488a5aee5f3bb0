package org.selectiverenderer.radiosity.trace;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Intersects rays with a scene that has versions of objects. Rays from bodies without versions and
 * from reference versions see the scene with all reference versions; for rays from any other
 * version its object's reference version is replaced by that version. So every version is lit in
 * place and none shadows another of the same object. Immutable; for several threads.
 */
public final class SceneIntersector {
  private final TriangleBvh all;
  private final TriangleBvh[] own;
  private final int[] objectOf;

  /**
   * Per version: the tree that its triangles are in; 0 is the tree that all rays are tested
   * against.
   */
  private final int[] treeOf;

  public SceneIntersector(SceneTriangles triangles, ObjectVersionIndex versions) {
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
    TriangleBvh[] trees = new TriangleBvh[members.length];
    IntStream.range(0, members.length)
        .parallel()
        .forEach(
            i -> {
              if (i == 0 || members[i].length > 0) {
                trees[i] = new TriangleBvh(triangles, members[i], objectOf);
              }
            });
    all = trees[0];
    own = trees;
  }

  /**
   * Finds the first hit of a ray; {@code ray.triangle} is {@link Ray#NOTHING} if there is none.
   *
   * @param version the version of an object that the ray starts from
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

  /** Returns the share of light that passes along a ray up to its length. */
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
