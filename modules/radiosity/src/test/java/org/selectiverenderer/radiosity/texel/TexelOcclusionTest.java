package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Photometry;

/** Light at texels beside, under and inside of things, and on joints. */
class TexelOcclusionTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'";
  private static final String LAMP = "<PointLight location='2 3 2'/>";
  private static final String FLOOR = quad("0 0 4, 4 0 4, 4 0 0, 0 0 0", GREY);

  /** A room of 4 m without its floor, which is body 0. */
  private static final String ROOM = FLOOR + room(0, 0, 0, 4, GREY).replace("4 5 1 0 -1", "");

  private static String box(double x, double y, double z, String size) {
    return "<Transform translation='%s %s %s'><Shape><Appearance><Material %s/></Appearance>"
            .formatted(x, y, z, GREY)
        + "<Box size='%s'/></Shape></Transform>".formatted(size);
  }

  @Test
  void noLightLeaksUnderASlabCloseToTheFloor() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(ROOM + box(2, 0.05, 2, "1.6 0.06 1.6") + LAMP, 16, 0.5);
    double open = lit.at(0, 0.8, 0, 2);
    assertThat(open).isPositive();
    lit.each(
        0,
        (p, lux) -> {
          double under = 0.8 - Math.max(Math.abs(p[0] - 2), Math.abs(p[2] - 2));
          if (under > 0.3) {
            assertThat(lux).isLessThan(0.02 * open);
          }
        });
  }

  /**
   * What a box that stands on a floor covers, nobody sees: it must not darken what is beside it.
   */
  @Test
  void theFloorBesideABoxIsNotDarkenedByWhatTheBoxCovers() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(ROOM + box(2, 0.1, 2, "1.01 0.2 1.01") + LAMP, 16, 0.5);
    double open = lit.at(0, 2, 0, 1.2);
    lit.each(0, (p, lux) -> assertThat(lux).isGreaterThan(0.35 * open));
  }

  @Test
  void aContactShadowDarkensTowardsTheWallAboveIt() throws Exception {
    // A black board on edge takes up to half of what the floor sees.
    String board = box(2, 0.3, 3, "2 0.6 0.02").replace(GREY, "diffuseColor='0 0 0'");
    TexelSceneFixture lit = TexelSceneFixture.of(ROOM + board + LAMP, 24, 0.4);
    double near = lit.at(0, 2, 0, 3.07);
    double far = lit.at(0, 2, 0, 3.2);
    assertThat(near).isLessThan(0.85 * far);
    assertThat(near).isPositive();
  }

  /**
   * Closed form: a long strip of height h and radiance L that stands on a floor gives it pi L / 2
   * (1 - x / sqrt(x^2 + h^2)) at the distance x, which falls to a half within two texels.
   */
  @Test
  void besideALowBoardLightFallsAsSteeplyAsItDoes() throws Exception {
    double height = 0.1;
    String floor = quad("-4 0 1, 4 0 1, 4 0 0, -4 0 0", "diffuseColor='0 0 0'");
    String board = quad("-4 0 0, 4 0 0, 4 0.1 0, -4 0.1 0", GREY);
    TexelSceneFixture lit =
        TexelSceneFixture.of(floor + board + "<DirectionalLight direction='0 0 -1'/>", 24, 0.1);
    double radiance = Photometry.linear(0.735) * Photometry.WHITE; // The sun gives 250 pi lx.
    double[] sums = new double[6];
    double[] counts = new double[6];
    lit.each(
        0,
        (p, lux) -> {
          int row = (int) (p[2] * 24);
          if (row < sums.length && Math.abs(p[0]) < 3) {
            double expected = 1 - p[2] / Math.hypot(p[2], height);
            sums[row] += lux / (Math.PI * radiance / 2) - expected;
            counts[row]++;
          }
        });
    for (int row = 0; row < sums.length; row++) {
      assertThat(sums[row] / counts[row]).as("row %s", row).isCloseTo(0, within(0.07));
    }
  }

  /** A wall is often set back a little behind its skirting board; here it is a floor. */
  @Test
  void whatLiesRightBehindASkirtingBoardDoesNotDarkenTheWallBesideIt() throws Exception {
    String floor = quad("0 0 3.9, 4 0 3.9, 4 0 0, 0 0 0", GREY);
    String setBack = quad("0 -0.002 4, 4 -0.002 4, 4 -0.002 3.9, 0 -0.002 3.9", GREY);
    String walls = room(0, 0, 0, 4, GREY).replace("4 5 1 0 -1", "");
    String board = box(2, 0.035, 3.951, "4 0.07 0.1");
    TexelSceneFixture alone = TexelSceneFixture.of(floor + walls + board + LAMP, 24, 0.4);
    TexelSceneFixture both = TexelSceneFixture.of(floor + setBack + walls + board + LAMP, 24, 0.4);
    double half = 0.5 / 24;
    for (double x = 0.5; x < 3.5; x += 0.25) {
      double expected = alone.at(0, x, 0, 3.9 - half);
      assertThat(both.at(0, x, 0, 3.9 - half))
          .as("%s", x)
          .isCloseTo(expected, within(0.03 * expected));
    }
  }

  @Test
  void onAJointOfTwoFloorsBothHaveTheSameLight() throws Exception {
    String left = quad("0 0 4, 2 0 4, 2 0 0, 0 0 0", GREY);
    String right = quad("2 0 4, 4 0 4, 4 0 0, 2 0 0", GREY);
    String walls = room(0, 0, 0, 4, GREY).replace("4 5 1 0 -1", "");
    TexelSceneFixture lit =
        TexelSceneFixture.of(left + right + walls + "<PointLight location='1 3 1'/>", 16, 0.5);
    double half = 0.5 / 16;
    for (double z = 0.5; z < 3.5; z += 0.25) {
      double one = lit.at(0, 2 - half, 0, z);
      double other = lit.at(1, 2 + half, 0, z);
      double before = lit.at(0, 2 - 3 * half, 0, z);
      // As much as light changes from one texel to the next, and no step.
      assertThat(other - one).isCloseTo(one - before, within(0.006 * one));
    }
  }

  @Test
  void theSameBytesWithOneThreadAndWithFour() throws Exception {
    String scene = ROOM + box(2, 0.3, 2, "0.6 0.6 0.6") + LAMP;
    TexelSceneFixture one = with(1, scene);
    TexelSceneFixture four = with(4, scene);
    assertThat(one.pages().rays()).isEqualTo(four.pages().rays());
    for (int page = 0; page < one.irradiance().size(); page++) {
      assertThat(four.irradiance().get(page)).isEqualTo(one.irradiance().get(page));
    }
  }

  private static TexelSceneFixture with(int threads, String scene) throws Exception {
    ForkJoinPool pool = new ForkJoinPool(threads);
    try {
      return pool.submit(() -> TexelSceneFixture.of(scene, 8, 0.5)).get();
    } finally {
      pool.shutdown();
    }
  }

  @Test
  void whatIsCancelledHasTheLightOfThePatches() throws Exception {
    RadiosityProgress cancelled =
        new RadiosityProgress() {
          private volatile boolean enough;

          @Override
          public void at(Stage stage, double share) {
            enough |= stage == Stage.TEXELS && share > 0.5;
          }

          @Override
          public boolean cancelled() {
            return enough;
          }
        };
    TexelSceneFixture lit = TexelSceneFixture.of(ROOM + LAMP, 12, 0.5, cancelled);
    assertThat(lit.pages().complete()).isFalse();
    double whole = TexelSceneFixture.of(ROOM + LAMP, 12, 0.5).at(0, 2, 0, 1);
    assertThat(lit.at(0, 2, 0, 1)).isCloseTo(whole, within(0.15 * whole));
  }
}
