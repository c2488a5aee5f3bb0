package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.radiosity.TestScenes.quad;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.TestScenes;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** From the origin of a floor of texels of 0.1 m. */
class NearbyWallPlanesTest {
  private static final double[] UP = {0, 1, 0};
  private static final String GREY = "diffuseColor='0.7 0.7 0.7'";

  /** Stands at x = 0.3 and faces the place. */
  private static final String WALL = quad("0.3 0 -1, 0.3 0 1, 0.3 1 1, 0.3 1 -1", GREY);

  /** Stands at x = -0.2, 0.05 m high, and faces the other way: rays meet its back. */
  private static final String STEP = quad("-0.2 0 -1, -0.2 0 1, -0.2 0.05 1, -0.2 0.05 -1", GREY);

  private static float[] around(String scene, double[]... directions) throws Exception {
    RadiosityScene read = TestScenes.read(scene + "<DirectionalLight/>");
    NearbyWallPlanes walls = new NearbyWallPlanes(read);
    walls.begin(UP, 0.1);
    for (double[] direction : directions) {
      Ray ray = new Ray();
      ray.from(new double[] {0, 1e-6, 0}, direction);
      ray.length = Double.POSITIVE_INFINITY;
      read.visibility().nearest(ray, 0);
      assertThat(ray.triangle).isNotEqualTo(Ray.NOTHING);
      walls.met(ray);
    }
    float[] out = new float[NearbyWallPlanes.NUMBERS];
    walls.write(out);
    return out;
  }

  private static double[] to(double x, double y, double z) {
    double length = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / length, y / length, z / length};
  }

  @Test
  void aWallStandsBetweenThePlacesOnItsTwoSides() throws Exception {
    float[] walls = around(WALL, to(1, 0.2, 0.4));
    assertThat(NearbyWallPlanes.between(walls, 0, 0.29, 0, 0)).isFalse();
    assertThat(NearbyWallPlanes.between(walls, 0, 0.31, 0, 0)).isTrue();
    assertThat(NearbyWallPlanes.between(walls, 0, 0.31, 0, 5)).isTrue();
    assertThat(NearbyWallPlanes.between(walls, 0, -1, 0, 0)).isFalse();
  }

  @Test
  void wallsOnSeveralSidesCountEach() throws Exception {
    float[] walls = around(WALL + STEP, to(1, 0.2, 0.4), to(-1, 0.1, 0.1));
    assertThat(NearbyWallPlanes.between(walls, 0, 0.31, 0, 0)).isTrue();
    assertThat(NearbyWallPlanes.between(walls, 0, -0.21, 0, 0)).isTrue();
    assertThat(NearbyWallPlanes.between(walls, 0, -0.19, 0, 0)).isFalse();
    assertThat(NearbyWallPlanes.between(walls, 0, 0, 0, 0.5)).isFalse();
  }

  @Test
  void theNearestOfOneSideCountsInWhateverOrderTheyAreMet() throws Exception {
    String before = WALL.replace("0.3", "0.2").replace(" 1 1, 0.2 1 ", " 0.05 1, 0.2 0.05 ");
    double[] low = to(1, 0.1, 0);
    double[] high = to(1, 0.5, 0);
    for (float[] walls :
        new float[][] {around(WALL + before, low, high), around(WALL + before, high, low)}) {
      assertThat(NearbyWallPlanes.between(walls, 0, 0.21, 0, 0)).isTrue();
      assertThat(NearbyWallPlanes.between(walls, 0, 0.19, 0, 0)).isFalse();
    }
  }

  @Test
  void whatIsFarOrAboveOrLiesOnTheSurfaceDividesNothing() throws Exception {
    String far = WALL.replace("0.3", "0.9");
    assertThat(around(far, to(1, 0.01, 0))).containsOnly(0);
    assertThat(around(WALL, to(0.3, 0.6, 0))).containsOnly(0);
    String ramp = quad("0.3 0 -1, 0.3 0 1, 0.5 0.1 1, 0.5 0.1 -1", GREY);
    assertThat(around(ramp, to(0.4, 0.02, 0))).containsOnly(0);
  }

  @Test
  void moreRaysAddWhatTheyFind() throws Exception {
    float[] all = around(WALL, to(1, 0.2, 0.4));
    NearbyWallPlanes.join(all, 0, around(STEP, to(-1, 0.1, 0.1)));
    assertThat(NearbyWallPlanes.between(all, 0, 0.31, 0, 0)).isTrue();
    assertThat(NearbyWallPlanes.between(all, 0, -0.21, 0, 0)).isTrue();
  }
}
