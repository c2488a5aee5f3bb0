package org.selectiverenderer.radiosity.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.TestScenes;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** The reference itself against closed forms, conservation and the law of large numbers. */
class PathTracerTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'";
  private static final String BLACK = "diffuseColor='0 0 0'";
  private static final double HALF = Photometry.linear(0.735);
  private static final String FLOOR = quad("-1 0 1, 1 0 1, 1 0 -1, -1 0 -1", GREY);

  /** Follows paths from evenly drawn places of some triangles. */
  private static final class Places {
    final RadiosityScene scene;
    final PathTracer tracer;
    final SplittableRandom random;
    final double[] sums;
    double area;

    Places(RadiosityScene scene, int from, int to, long seed) {
      this.scene = scene;
      tracer = new PathTracer(scene, new SceneEmitters(scene));
      random = new SplittableRandom(seed);
      sums = new double[to - from];
      double[] normal = new double[3];
      for (int i = 0; i < sums.length; i++) {
        area += scene.triangles().normal(from + i, normal);
        sums[i] = area;
      }
    }

    /** Mean irradiance, lx, of so many paths. */
    double irradiance(int from, int paths) {
      double[] sum = new double[3];
      for (int i = 0; i < paths; i++) {
        double wanted = area * (i + random.nextDouble()) / paths;
        int triangle = 0;
        while (triangle < sums.length - 1 && sums[triangle] < wanted) {
          triangle++;
        }
        double root = Math.sqrt(random.nextDouble());
        double t = random.nextDouble();
        tracer.add(
            from + triangle, root * (1 - t), root * t, false, true, draw(random), random, sum);
      }
      return Math.PI * sum[1] / paths;
    }
  }

  private static PathTracer.First draw(SplittableRandom random) {
    return new PathTracer.First(
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble());
  }

  private static double at(RadiosityScene scene, double u, double v, int paths) {
    PathTracer tracer = new PathTracer(scene, new SceneEmitters(scene));
    SplittableRandom random = new SplittableRandom(1);
    double[] sum = new double[3];
    for (int i = 0; i < paths; i++) {
      tracer.add(0, u, v, false, true, draw(random), random, sum);
    }
    return Math.PI * sum[1] / paths;
  }

  @Test
  void inAFurnaceEverySurfaceHasTheSameLight() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 2, GREY + " emissiveColor='0.735 0.735 0.735'"));
    double expected = Math.PI * HALF * Photometry.WHITE / (1 - HALF);
    for (int wall = 0; wall < 6; wall++) {
      double light = new Places(scene, 2 * wall, 2 * wall + 2, wall).irradiance(2 * wall, 20_000);
      assertThat(light).isCloseTo(expected, within(0.01 * expected));
    }
  }

  /** Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11: 0.19982. */
  @Test
  void lightBetweenParallelSquaresIsThatOfTheCatalogue() throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            quad("1 1 1, 2 1 1, 2 2 1, 1 2 1", BLACK)
                + quad("1 1 2, 1 2 2, 2 2 2, 2 1 2", BLACK + " emissiveColor='1 1 1'"));
    double light = new Places(scene, 0, 2, 5).irradiance(0, 50_000);
    double factor = light / (Math.PI * Photometry.WHITE);
    assertThat(factor).isCloseTo(0.19982, within(0.001));
  }

  @Test
  void aPointLightFallsOffWithTheSquareAndTheCosine() throws Exception {
    RadiosityScene scene = TestScenes.read(FLOOR + "<PointLight location='3 4 0'/>");
    // The middle of the floor's diagonal, five metres from the lamp.
    double expected = 250 * Math.PI / 25 * 4 / 5;
    assertThat(at(scene, 0, 0.5, 10)).isCloseTo(expected, within(1e-3 * expected));
  }

  /** Close to a window nothing may be cut off: the corner formula of a parallel rectangle. */
  @Test
  void aRectangleIsSeenInFullFromNearby() throws Exception {
    String lamp =
        "<SpotLight location='0 0.02 0' direction='0 -1 0' cutOffAngle='1.57'>"
            + "<MetadataSet containerField='metadata' name='photometric'>"
            + "<MetadataFloat containerField='value' name='size' value='2 2'/>"
            + "<MetadataFloat containerField='value' name='luminance' value='1000'/>"
            + "</MetadataSet></SpotLight>";
    RadiosityScene scene = TestScenes.read(FLOOR + lamp);
    // Four quarters with sides of one metre, two centimetres away.
    double x = 1 / 0.02;
    double root = Math.sqrt(1 + x * x);
    double expected = Math.PI * 1000 * 4 / Math.PI * (x / root) * Math.atan(x / root);
    assertThat(at(scene, 0, 0.5, 20_000)).isCloseTo(expected, within(0.01 * expected));
  }

  @Test
  void aPaneLetsThroughItsShare() throws Exception {
    String sun = "<DirectionalLight direction='0 -1 0'/>";
    String pane = quad("-5 1 5, 5 1 5, 5 1 -5, -5 1 -5", BLACK + " transparency='0.75'");
    double free = at(TestScenes.read(FLOOR + sun), 0.3, 0.4, 10);
    double less = at(TestScenes.read(FLOOR + pane + sun), 0.3, 0.4, 2000);
    assertThat(free).isCloseTo(250 * Math.PI, within(0.1));
    assertThat(less).isCloseTo(0.75 * free, within(1e-3 * free));
  }

  @Test
  void noLightIsLostInAClosedRoom() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, GREY) + "<PointLight location='2 3 1'/>");
    Places walls = new Places(scene, 0, 12, 9);
    double absorbed = (1 - HALF) * walls.irradiance(0, 60_000) * walls.area;
    assertThat(absorbed).isCloseTo(scene.lumens(), within(0.01 * scene.lumens()));
  }

  /** Sixteen times as many paths have a quarter of the error, as white noise has. */
  @Test
  void theErrorFallsWithTheRootOfThePaths() throws Exception {
    RadiosityScene scene =
        TestScenes.read(room(0, 0, 0, 4, GREY) + "<PointLight location='2 3 1'/>");
    Places walls = new Places(scene, 0, 2, 3);
    double few = deviation(walls, 32);
    double many = deviation(walls, 512);
    assertThat(few / many).isBetween(3.0, 5.3);
  }

  private static double deviation(Places walls, int paths) {
    int tries = 64;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < tries; i++) {
      double light = walls.irradiance(0, paths);
      sum += light;
      squares += light * light;
    }
    return Math.sqrt(squares / tries - sum * sum / tries / tries);
  }
}
