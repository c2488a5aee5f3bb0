package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** What nobody sees, as no light gets there, must not darken what is beside it. */
class ClosedCavityTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'";
  private static final String BLACK = "diffuseColor='0 0 0'";

  /** A room of 4 m with its floor as body 0. */
  private static final String ROOM =
      quad("0 0 4, 4 0 4, 4 0 0, 0 0 0", GREY) + room(0, 0, 0, 4, GREY).replace("4 5 1 0 -1", "");

  /** Half of the side of what stands in the middle of the floor. */
  private static final double HALF = 0.15;

  /** Four sides of 30 cm that stand in the middle of the floor, and a sheet across them. */
  private static String sides(double height, double sheet, String material) {
    String corners = "";
    for (double y : new double[] {0, height, sheet}) {
      corners += "1.85 %1$s 1.85 2.15 %1$s 1.85 2.15 %1$s 2.15 1.85 %1$s 2.15 ".formatted(y);
    }
    return ("<Shape><Appearance><Material %s/></Appearance><IndexedFaceSet solid='false' "
            + "coordIndex='0 4 5 1 -1 1 5 6 2 -1 2 6 7 3 -1 3 7 4 0 -1 8 11 10 9 -1'>"
            + "<Coordinate point='%s'/></IndexedFaceSet></Shape>")
        .formatted(material, corners);
  }

  private static double fromMiddle(double[] point) {
    return Math.max(Math.abs(point[0] - 2), Math.abs(point[2] - 2));
  }

  @Test
  void theFloorBesideABinIsNotDarkenedByTheHollowInItsFoot() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            ROOM + sides(0.3, 0.02, GREY) + "<PointLight location='2 3.5 2'/>", 24, 0.3);
    double beside = lit.at(0, 2 + HALF + 0.5 / 24, 0, 2);
    assertThat(beside).isPositive();
    lit.each(
        0,
        (p, lux) -> {
          if (fromMiddle(p) < HALF - 1.0 / 24) {
            assertThat(lux).isGreaterThan(0.5 * beside);
          }
        });
  }

  /** Nearer to the floor than rays start, which see the bin from inside then. */
  @Test
  void norByABottomThatLiesOnTheFloor() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            ROOM + sides(0.3, 0.00002, GREY) + "<PointLight location='0.3 0.5 2'/>", 24, 0.3);
    double beside = lit.at(0, 2 - HALF - 0.5 / 24, 0, 2);
    assertThat(beside).isPositive();
    lit.each(
        0,
        (p, lux) -> {
          if (fromMiddle(p) < HALF - 1.0 / 24) {
            assertThat(lux).as(() -> Arrays.toString(p)).isGreaterThan(0.1 * beside);
          }
        });
  }

  /** A candle in a closed black lantern: nothing but its own light is there. */
  @Test
  void aLampInAHollowLightsIt() throws Exception {
    String floor = quad("1.5 0 2.5, 2.5 0 2.5, 2.5 0 1.5, 1.5 0 1.5", GREY);
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            floor + sides(0.3, 0.3, BLACK) + "<PointLight location='2 0.2 2'/>", 24, 0.3);
    double candela = 250 * Math.PI;
    int[] inside = {0};
    lit.each(
        0,
        (p, lux) -> {
          if (fromMiddle(p) < HALF - 1.0 / 24) {
            double away = Math.sqrt(Math.pow(p[0] - 2, 2) + 0.04 + Math.pow(p[2] - 2, 2));
            double expected = candela * 0.2 / Math.pow(away, 3);
            assertThat(lux).isCloseTo(expected, within(0.02 * expected));
            inside[0]++;
          }
        });
    assertThat(inside[0]).isPositive();
  }
}
