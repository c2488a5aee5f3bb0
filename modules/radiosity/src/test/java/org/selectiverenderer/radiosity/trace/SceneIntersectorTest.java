package org.selectiverenderer.radiosity.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** What rays meet in a tree is what they meet of all triangles, one by one. */
class SceneIntersectorTest {
  private static final double[][] ALONG = {
    {1, 0, 0}, {-1, 0, -0.0}, {0, 1, 0}, {-0.0, -1, 0}, {0, 0, 1}, {0, -0.0, -1}, {1, 1e-35, 0}
  };

  private final Random random = new Random(5);

  /** Triangles of all sizes; a third of them lies in planes x, y or z = a quarter of a number. */
  private float[] corners(int count, float scale) {
    float[] corners = new float[9 * count];
    for (int i = 0; i < count; i++) {
      float size = (float) Math.exp(-4 * random.nextDouble());
      float[] at = {random.nextFloat(), random.nextFloat(), random.nextFloat()};
      int plane = i % 9 < 3 ? i % 9 : -1;
      for (int k = 0; k < 9; k++) {
        float value = k % 3 == plane ? 0.25f * (i % 4) : at[k % 3] + size * random.nextFloat();
        corners[9 * i + k] = scale * value;
      }
    }
    return corners;
  }

  private static SceneIntersector of(float[] corners, int from, int to) {
    int count = to - from;
    float[] own = Arrays.copyOfRange(corners, 9 * from, 9 * to);
    return new SceneIntersector(
        new SceneTriangles(own, new boolean[count], new float[count], new int[count]),
        new ObjectVersionIndex());
  }

  private double[] direction(int i) {
    return i % 3 == 0
        ? ALONG[i / 3 % ALONG.length]
        : new double[] {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
  }

  private void sameAsOneByOne(float scale, double away) {
    int count = 300;
    float[] corners = corners(count, scale);
    SceneIntersector all = of(corners, 0, count);
    SceneIntersector[] each =
        IntStream.range(0, count)
            .mapToObj(i -> of(corners, i, i + 1))
            .toArray(SceneIntersector[]::new);
    Ray ray = new Ray();
    ray.pass = 0.5;
    int met = 0;
    for (int i = 0; i < 600; i++) {
      double[] to = direction(i);
      double[] from = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        // Some start in the triangles' own planes.
        double place = i % 2 == 0 ? 0.25 * random.nextInt(5) : 1.2 * random.nextDouble();
        from[axis] = scale * (place - away * to[axis]);
      }
      double nearest = Double.POSITIVE_INFINITY;
      for (SceneIntersector one : each) {
        nearest = Math.min(nearest, length(one, ray, from, to));
      }
      // Where solids touch, a ray leaves one before it enters the other: see Ray.
      assertThat(length(all, ray, from, to))
          .isBetween(nearest - 3e-6 * scale, nearest + 3e-6 * scale);
      boolean hidden = Double.isFinite(nearest);
      met += hidden ? 1 : 0;
      ray.from(from, to);
      ray.length = Double.POSITIVE_INFINITY;
      assertThat(all.transmittance(ray, ObjectVersionIndex.FIXED)).isEqualTo(hidden ? 0 : 1);
    }
    assertThat(met).isBetween(100, 590);
  }

  private static double length(SceneIntersector of, Ray ray, double[] from, double[] to) {
    ray.from(from, to);
    ray.length = Double.POSITIVE_INFINITY;
    of.nearest(ray, ObjectVersionIndex.FIXED);
    return ray.length;
  }

  @Test
  void raysInATreeMeetWhatIsNearest() {
    sameAsOneByOne(1, 0);
  }

  @Test
  void soDoThoseFromFarAwayAndInSmallAndLargeScenes() {
    sameAsOneByOne(1, 40);
    sameAsOneByOne(1e-3f, 0);
    sameAsOneByOne(1e4f, 3);
  }

  @Test
  void nothingIsMetInAnEmptyScene() {
    Ray ray = new Ray();
    assertThat(length(of(new float[0], 0, 0), ray, new double[3], new double[] {0, 0, 1}))
        .isInfinite();
    assertThat(ray.triangle).isEqualTo(Ray.NOTHING);
  }
}
