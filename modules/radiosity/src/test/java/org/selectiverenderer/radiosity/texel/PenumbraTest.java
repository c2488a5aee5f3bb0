package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.quad;

import org.junit.jupiter.api.Test;

/** Shadows of lamps with a size. */
class PenumbraTest {
  private static final String BLACK = "diffuseColor='0 0 0'";
  private static final int DENSITY = 32;

  /** A lamp of one square metre, 2 m above a floor. */
  private static final String OPEN =
      quad("-1 0 1, 1 0 1, 1 0 -1, -1 0 -1", BLACK)
          + "<SpotLight location='0 2 0' direction='0 -1 0' cutOffAngle='1.5707'>"
          + "<MetadataSet containerField='metadata' name='photometric'>"
          + "<MetadataFloat containerField='value' name='size' value='1 1'/>"
          + "<MetadataFloat containerField='value' name='luminance' value='1000'/>"
          + "</MetadataSet></SpotLight>";

  /** Half way up it hides a half. */
  private static final String BOARD =
      quad("-6 1 6, 0 1 6, 0 1 -6, -6 1 -6", BLACK)
          .replace("<IndexedFaceSet", "<IndexedFaceSet solid='false'");

  /**
   * At x the part 0.5 + x of the lamp is seen. All of a texel's few rays may miss that by chance,
   * and must not leave a dot.
   */
  @Test
  void whereLittleOfALampIsSeenNoTexelStandsOut() throws Exception {
    double open = TexelSceneFixture.of(OPEN, DENSITY, 0.5).at(0, 0, 0, 0);
    TexelSceneFixture lit = TexelSceneFixture.of(OPEN + BOARD, DENSITY, 0.5);
    double[] sums = new double[2 * DENSITY];
    int[] counts = new int[2 * DENSITY];
    lit.each(
        0,
        (p, lux) -> {
          if (inHalfShadow(p)) {
            sums[column(p)] += lux;
            counts[column(p)]++;
          }
        });
    lit.each(
        0,
        (p, lux) -> {
          if (inHalfShadow(p)) {
            double mean = sums[column(p)] / counts[column(p)];
            assertThat(lux).as("%s %s", p[0], p[2]).isCloseTo(mean, within(0.05 * open));
          }
        });
    assertThat(counts[DENSITY]).isPositive();
  }

  private static int column(double[] point) {
    return (int) Math.floor((point[0] + 1) * DENSITY);
  }

  private static boolean inHalfShadow(double[] point) {
    return Math.abs(point[0]) < 0.48 && Math.abs(point[2]) < 0.4;
  }
}
