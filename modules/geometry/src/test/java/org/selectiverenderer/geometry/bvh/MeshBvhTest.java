package org.selectiverenderer.geometry.bvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.Random;
import java.util.TreeSet;
import org.joml.Intersectiond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.bvh.MeshBvh.MeshHit;
import org.selectiverenderer.geometry.bvh.MeshBvh.Sides;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TestMeshes;

class MeshBvhTest {
  private static final double FAR = Double.POSITIVE_INFINITY;

  private static Vector3d random(Random random, double half) {
    return new Vector3d(random.nextDouble(), random.nextDouble(), random.nextDouble())
        .mul(2 * half)
        .sub(half, half, half);
  }

  @Test
  void aRayMeetsASphereWhereTheFormulaSays() {
    MeshBvh sphere = new MeshBvh(TestMeshes.sphere(128));
    Random random = new Random(1);
    for (int i = 0; i < 1000; i++) {
      Vector3d origin = random(random, 1).normalize(3);
      Vector3d aim = random(random, 0.5);
      Vector3d direction = aim.sub(origin, new Vector3d()).normalize();
      double b = origin.dot(direction);
      double expected = -b - Math.sqrt(b * b - 8);
      MeshHit hit = sphere.nearest(origin, direction, FAR, Sides.FRONT).orElseThrow();
      assertThat(hit.distance()).isCloseTo(expected, within(2e-3));
    }
  }

  @Test
  void randomRaysHitWhatTryingEveryTriangleFinds() {
    Random random = new Random(2);
    Mesh soup = TestMeshes.soup(3000, random);
    MeshBvh bvh = new MeshBvh(soup);
    int hits = 0;
    for (int i = 0; i < 2000; i++) {
      Vector3d origin = random(random, 15);
      Vector3d direction = random(random, 1);
      double limit = i % 3 == 0 ? 5 / direction.length() : FAR;
      double expected = bruteForce(bvh, 3000, origin, direction, limit);
      Optional<MeshHit> hit = bvh.nearest(origin, direction, limit, Sides.BOTH);
      assertThat(hit.map(MeshHit::distance).orElse(-1.0)).isCloseTo(expected, within(1e-6));
      hits += hit.isPresent() ? 1 : 0;
    }
    assertThat(hits).isBetween(200, 1900);
  }

  private static double bruteForce(
      MeshBvh bvh, int triangles, Vector3d origin, Vector3d direction, double limit) {
    double nearest = -1;
    for (int t = 0; t < triangles; t++) {
      double at =
          Intersectiond.intersectRayTriangle(
              origin,
              direction,
              bvh.corner(t, 0, new Vector3d()),
              bvh.corner(t, 1, new Vector3d()),
              bvh.corner(t, 2, new Vector3d()),
              0);
      if (at >= 0 && at <= limit && (nearest < 0 || at < nearest)) {
        nearest = at;
      }
    }
    return nearest;
  }

  @Test
  void axisParallelRaysThroughEdgesAndCornersOfABoxHitIt() {
    MeshBvh box = new MeshBvh(TestMeshes.box(-1, -1, -1, 1, 1, 1));
    for (double x : new double[] {-1, 0, 1}) {
      for (double y : new double[] {-1, 0, 1}) {
        assertThat(box.nearest(new Vector3d(x, y, 5), new Vector3d(0, 0, -1), FAR, Sides.BOTH))
            .map(MeshHit::distance)
            .contains(4.0);
      }
    }
    assertThat(box.nearest(new Vector3d(1.001, 0, 5), new Vector3d(0, 0, -1), FAR, Sides.BOTH))
        .isEmpty();
  }

  @Test
  void barycentricsNameThePointHit() {
    MeshBvh quad = new MeshBvh(TestMeshes.quad(true, 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0));
    MeshHit hit =
        quad.nearest(new Vector3d(1.5, 0.25, 3), new Vector3d(0, 0, -1), FAR, Sides.FRONT)
            .orElseThrow();
    Vector3d a = quad.corner(hit.triangle(), 0, new Vector3d());
    Vector3d point =
        a.mul(1 - hit.u() - hit.v(), new Vector3d())
            .fma(hit.u(), quad.corner(hit.triangle(), 1, new Vector3d()))
            .fma(hit.v(), quad.corner(hit.triangle(), 2, new Vector3d()));
    assertThat(point.distance(1.5, 0.25, 0)).isLessThan(1e-12);
  }

  @Test
  void aSideThatIsNotWantedIsNotHit() {
    MeshBvh box = new MeshBvh(TestMeshes.box(-1, -1, -1, 1, 1, 1));
    Vector3d out = new Vector3d(1, 0.1, 0.2);
    assertThat(box.nearest(new Vector3d(), out, FAR, Sides.FRONT)).isEmpty();
    assertThat(box.nearest(new Vector3d(), out, FAR, Sides.BOTH)).isPresent();
  }

  @Test
  void boxesAndDistancesFindTheTrianglesThatTryingEachFinds() {
    Random random = new Random(3);
    Mesh soup = TestMeshes.soup(2000, random);
    MeshBvh bvh = new MeshBvh(soup);
    for (int i = 0; i < 200; i++) {
      Vector3d centre = random(random, 10);
      double radius = random.nextDouble() * 3;
      TreeSet<Integer> found = new TreeSet<>();
      double[] box = BoundingBox.of(centre, centre).grown(radius).toArray();
      bvh.inBox(
          box,
          t -> {
            Vector3d near = new Vector3d();
            ClosestPoint.onTriangle(
                bvh.corner(t, 0, new Vector3d()),
                bvh.corner(t, 1, new Vector3d()),
                bvh.corner(t, 2, new Vector3d()),
                centre,
                near);
            if (near.distance(centre) <= radius) {
              found.add(t);
            }
          });
      TreeSet<Integer> expected = new TreeSet<>();
      for (int t = 0; t < 2000; t++) {
        Vector3d closest = new Vector3d();
        Intersectiond.findClosestPointOnTriangle(
            bvh.corner(t, 0, new Vector3d()),
            bvh.corner(t, 1, new Vector3d()),
            bvh.corner(t, 2, new Vector3d()),
            centre,
            closest);
        if (t % 50 != 0 && closest.distance(centre) <= radius) {
          expected.add(t);
        }
      }
      found.removeIf(t -> t % 50 == 0); // Points, for which JOML's formula divides by zero.
      assertThat(found).isEqualTo(expected);
    }
  }

  @Test
  void manyTrianglesInOnePlaceMakeNoDeepTree() {
    float[] positions = new float[9 * 100_000];
    int[] indices = new int[3 * 100_000];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = i;
      positions[3 * i] = i % 3 == 1 ? 1 : 0;
      positions[3 * i + 1] = i % 3 == 2 ? 1 : 0;
    }
    MeshBvh bvh = new MeshBvh(TestMeshes.of(positions, indices, false));
    assertThat(bvh.nearest(new Vector3d(0.2, 0.2, 1), new Vector3d(0, 0, -1), FAR, Sides.BOTH))
        .map(MeshHit::distance)
        .contains(1.0);
  }

  @Test
  void linesAndEmptyMeshesHaveNoSurface() {
    Mesh box = TestMeshes.box(-1, -1, -1, 1, 1, 1);
    Mesh lines =
        new Mesh(
            Mesh.Primitive.LINES,
            box.positions(),
            null,
            null,
            null,
            box.indices(),
            true,
            box.bounds());
    Vector3d origin = new Vector3d(0, 0, 5);
    Vector3d ahead = new Vector3d(0, 0, -1);
    assertThat(new MeshBvh(lines).nearest(origin, ahead, FAR, Sides.BOTH)).isEmpty();
    Mesh nothing = TestMeshes.of(new float[0], new int[0], true);
    assertThat(new MeshBvh(nothing).nearest(origin, ahead, FAR, Sides.BOTH)).isEmpty();
  }
}
