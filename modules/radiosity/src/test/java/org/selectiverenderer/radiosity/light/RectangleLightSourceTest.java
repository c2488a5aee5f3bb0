package org.selectiverenderer.radiosity.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;

/** Single places of a rectangle against the closed forms of all of it. */
class RectangleLightSourceTest {
  /** Two metres by one, looking down from a height of two. */
  private static final RectangleLightSource LAMP =
      new RectangleLightSource(
          new double[] {0, 2, 0},
          new double[] {1, 0, 0},
          new double[] {0, 0, 0.5},
          new double[] {0, -1, 0},
          new float[] {100, 100, 100},
          2,
          200 * Math.PI);

  /** Points under, beside, at the edge and at the corner of the lamp, near to it and far. */
  private static final double[][] POINTS = {
    {0, 1.9, 0},
    {0, 1.999999, 0},
    {0.3, 1.5, -0.2},
    {1, 1.7, 0},
    {1, 1.99, 0.5},
    {1.4, 1.99, 0.1},
    {-2, 1.8, 0.4},
    {0.2, -0.8, 0.1},
    {0, -4, 0}
  };

  @Test
  void placesAreSpreadAsTheLightFalls() {
    SobolPointSet places = new SobolPointSet(4096, 1, 9);
    double[] expected = new double[3];
    double[] one = new double[3];
    LightSample sample = new LightSample();
    for (double[] point : POINTS) {
      for (double[] normal : new double[][] {{0, 1, 0}, {0.6, 0.8, 0}, {0, 0, -1}}) {
        LAMP.unshadowed(point, normal, expected);
        double sum = 0;
        for (int i = 0; i < places.size(); i++) {
          LAMP.sample(point, places.x(i), places.y(i), sample);
          sample.onto(normal, one);
          sum += one[1] / places.size();
        }
        assertThat(sum)
            .as("%s %s %s", point[0], point[1], point[2])
            .isCloseTo(expected[1], within(0.005 * expected[1] + 1e-6));
      }
    }
  }

  /** Over the middle of a square of side 2h at height h a cube is seen: a sixth of the sphere. */
  @Test
  void theSolidAngleIsThatOfACubesFace() {
    SphericalRectangle rectangle = new SphericalRectangle();
    assertThat(rectangle.look(-3, 3, -3, 3, 3)).isCloseTo(4 * Math.PI / 6, within(1e-12));
    assertThat(rectangle.look(0, 3, 0, 3, 3)).isCloseTo(Math.PI / 6, within(1e-12));
  }

  /** However near a lamp is, no place of it is so bright that a few of them are no fair sample. */
  @Test
  void noPlaceIsBrighterThanAllOfTheHemisphere() {
    LightSample sample = new LightSample();
    SobolPointSet places = new SobolPointSet(256, 1, 9);
    for (double[] point : POINTS) {
      for (int i = 0; i < places.size(); i++) {
        LAMP.sample(point, places.x(i), places.y(i), sample);
        assertThat(sample.light[1]).isBetween(0.0, 2 * Math.PI * 100);
      }
    }
  }

  @Test
  void nothingShinesToItsBack() {
    LightSample sample = new LightSample();
    LAMP.sample(new double[] {0, 2.5, 0}, 0.5, 0.5, sample);
    assertThat(sample.light).containsOnly(0);
  }
}
