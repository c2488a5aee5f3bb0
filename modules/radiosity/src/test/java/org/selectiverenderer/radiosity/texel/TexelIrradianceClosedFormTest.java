package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.radiosity.scene.Photometry;

/** Light at texels against closed forms. */
class TexelIrradianceClosedFormTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'"; // Reflects a half.
  private static final String BLACK = "diffuseColor='0 0 0'";
  private static final double HALF = Photometry.linear(0.735);

  /** A point light without metadata. */
  private static final double CANDELA = 250 * Math.PI;

  private static String floor(double side, String material) {
    return quad(
        "%1$s 0 %2$s, %2$s 0 %2$s, %2$s 0 %1$s, %1$s 0 %1$s".formatted(-side / 2, side / 2),
        material);
  }

  @Test
  void aPointLampFallsOffWithTheSquareOfTheDistanceAndTheCosine() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(floor(4, BLACK) + "<PointLight location='0 1.5 0'/>", 16, 0.5);
    int[] seen = {0};
    lit.each(
        0,
        (p, lux) -> {
          double square = p[0] * p[0] + 1.5 * 1.5 + p[2] * p[2];
          double expected = CANDELA / square * 1.5 / Math.sqrt(square);
          assertThat(lux).isCloseTo(expected, within(0.01 * expected));
          seen[0]++;
        });
    assertThat(seen[0]).isEqualTo(64 * 64);
  }

  @Test
  void inAFurnaceEveryTexelHasTheSameLight() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            room(0, 0, 0, 2, GREY + " emissiveColor='0.735 0.735 0.735'"), 12, 0.5);
    double expected = Math.PI * HALF * Photometry.WHITE / (1 - HALF);
    lit.each(0, (p, lux) -> assertThat(lux).isCloseTo(expected, within(0.01 * expected)));
    assertThat(lit.pages().noise().places()).isPositive();
    assertThat(lit.pages().noise().most()).isLessThan(0.01);
  }

  /** Howell's catalogue, C-11 and C-14: the mean over the texels of a square is the form factor. */
  @Test
  void whatASquareGetsFromAnotherIsTheFormFactorOfTheCatalogue() throws Exception {
    String glows = "diffuseColor='0 0 0' emissiveColor='1 1 1'";
    String below = quad("0 0 1, 1 0 1, 1 0 0, 0 0 0", BLACK);
    String parallel = quad("0 1 0, 1 1 0, 1 1 1, 0 1 1", glows);
    String upright = quad("0 0 0, 1 0 0, 1 1 0, 0 1 0", glows);
    assertThat(meanOfFirst(below + parallel) / (Math.PI * Photometry.WHITE))
        .isCloseTo(0.19982, within(0.002));
    assertThat(meanOfFirst(below + upright) / (Math.PI * Photometry.WHITE))
        .isCloseTo(0.20004, within(0.002));
  }

  private static double meanOfFirst(String body) throws Exception {
    double[] sum = new double[2];
    TexelSceneFixture.of(body, 24, 0.3)
        .each(
            0,
            (p, lux) -> {
              sum[0] += lux;
              sum[1]++;
            });
    return sum[0] / sum[1];
  }

  /** Summed over small pieces of the lamp. */
  @Test
  void aRectangleLampGivesWhatItsPiecesGive() throws Exception {
    String lamp =
        "<SpotLight location='0 2 0' direction='0 -1 0'>"
            + "<MetadataSet containerField='metadata' name='photometric'>"
            + "<MetadataFloat containerField='value' name='size' value='1 1'/>"
            + "<MetadataFloat containerField='value' name='luminance' value='1000'/>"
            + "</MetadataSet></SpotLight>";
    TexelSceneFixture lit = TexelSceneFixture.of(floor(4, BLACK) + lamp, 4, 0.5);
    lit.each(
        0,
        (p, lux) -> {
          double expected = 0;
          int pieces = 40;
          for (int i = 0; i < pieces * pieces; i++) {
            double x = (i % pieces + 0.5) / pieces - 0.5 - p[0];
            double z = (i / pieces + 0.5) / pieces - 0.5 - p[2];
            double square = x * x + 4 + z * z;
            expected += 1000 * 4 / (square * square) / (pieces * pieces);
          }
          assertThat(lux).isCloseTo(expected, within(0.01 * expected));
        });
  }

  /**
   * Howell's catalogue, C-14, of a lamp that stands on the floor: light begins with a step in its
   * plane, which lies in the first row of texels, before or behind their middle.
   */
  @Test
  void aLampOnTheFloorGivesAllOfItsLightWhereverTexelsLie() throws Exception {
    String lamp =
        "<SpotLight location='0.5 0.5 0' direction='0 0 1'>"
            + "<MetadataSet containerField='metadata' name='photometric'>"
            + "<MetadataFloat containerField='value' name='size' value='1 1'/>"
            + "<MetadataFloat containerField='value' name='luminance' value='1000'/>"
            + "</MetadataSet></SpotLight>";
    for (double behind : new double[] {0.02, 0.05, 0.1}) {
      String floor =
          quad("0 0 1, 1 0 1, 1 0 %1$s, 0 0 %1$s".formatted(String.valueOf(-behind)), BLACK);
      double[] sum = new double[2];
      TexelSceneFixture.of(floor + lamp, 8, 0.3)
          .each(
              0,
              (p, lux) -> {
                sum[0] += lux;
                sum[1]++;
              });
      assertThat(sum[0] / sum[1] * (1 + behind) / (Math.PI * 1000))
          .as("%s m behind the lamp", behind)
          .isCloseTo(0.20004, within(0.002));
    }
  }

  @Test
  void theEdgeOfAPointLampsShadowIsAsSharpAsATexel() throws Exception {
    String blocker =
        quad("-0.25 1 2, 0.25 1 2, 0.25 1 -2, -0.25 1 -2", BLACK)
            .replace("<IndexedFaceSet", "<IndexedFaceSet solid='false'");
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            floor(2, BLACK) + blocker + "<PointLight location='0.003 2 0'/>", 32, 0.5);
    int[] edges = {0};
    lit.each(
        0,
        (p, lux) -> {
          double square = (p[0] - 0.003) * (p[0] - 0.003) + 4 + p[2] * p[2];
          double open = CANDELA / square * 2 / Math.sqrt(square);
          double inside = Math.min(p[0] + 0.503, 0.497 - p[0]) * 32;
          if (inside > 0.51) {
            assertThat(lux).isZero();
          } else if (inside < -0.51) {
            assertThat(lux).isCloseTo(open, within(0.01 * open));
          } else {
            // The part of the texel that is in the light.
            assertThat(lux / open).as("%s %s", p[0], p[2]).isCloseTo(0.5 - inside, within(0.05));
            edges[0]++;
          }
        });
    assertThat(edges[0]).isEqualTo(2 * 64);
  }

  /** Walls of no thickness, and of less than a texel: what stands on a floor divides its light. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.01, 0.15})
  void noLightComesThroughAWall(double thickness) throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            room(0, 0, 0, 2, GREY)
                + room(2 + thickness, 0, 0, 2, GREY)
                + "<PointLight location='1 1 1'/>",
            10,
            0.3);
    lit.each(0, (p, lux) -> assertThat(lux).isPositive());
    lit.each(1, (p, lux) -> assertThat(lux).as(() -> Arrays.toString(p)).isZero());
  }

  @Test
  void aPaneLetsThroughItsShare() throws Exception {
    String pane =
        quad("-5 1 5, 5 1 5, 5 1 -5, -5 1 -5", "diffuseColor='0 0 0' transparency='0.75'");
    String lamp = "<DirectionalLight direction='0 -1 0'/>";
    double free = TexelSceneFixture.of(floor(2, BLACK) + lamp, 8, 0.5).at(0, 0, 0, 0);
    TexelSceneFixture covered = TexelSceneFixture.of(floor(2, BLACK) + pane + lamp, 8, 0.5);
    covered.each(0, (p, lux) -> assertThat(lux).isCloseTo(0.75 * free, within(0.001 * free)));
  }

  @Test
  void aSheetHasTheLightOfItsBrighterSide() throws Exception {
    String sheet = floor(2, BLACK).replace("<IndexedFaceSet", "<IndexedFaceSet solid='false'");
    for (int side = -1; side <= 1; side += 2) {
      String lamp = "<PointLight location='0 %d 0'/>".formatted(2 * side);
      TexelSceneFixture lit = TexelSceneFixture.of(sheet + lamp, 8, 0.5);
      lit.each(
          0,
          (p, lux) -> {
            double square = p[0] * p[0] + 4 + p[2] * p[2];
            double expected = CANDELA / square * 2 / Math.sqrt(square);
            assertThat(lux).isCloseTo(expected, within(0.01 * expected));
          });
    }
  }
}
