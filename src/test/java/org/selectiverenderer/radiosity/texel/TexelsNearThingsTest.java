package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.SmallScene.quad;
import static org.selectiverenderer.radiosity.SmallScene.room;

import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.work.WorkProgress;

/** Light at texels beside, under and inside of things, and on joints. */
class TexelsNearThingsTest {
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
    TexelLight lit = TexelLight.of(ROOM + box(2, 0.05, 2, "1.6 0.06 1.6") + LAMP, 16, 0.5);
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
    TexelLight lit = TexelLight.of(ROOM + box(2, 0.1, 2, "1.01 0.2 1.01") + LAMP, 16, 0.5);
    double open = lit.at(0, 2, 0, 1.2);
    lit.each(0, (p, lux) -> assertThat(lux).isGreaterThan(0.35 * open));
  }

  @Test
  void aContactShadowDarkensTowardsTheWallAboveIt() throws Exception {
    // A board on edge, away from the lamp: its far side is in the shade, and the floor there.
    TexelLight lit = TexelLight.of(ROOM + box(2, 0.3, 3, "2 0.6 0.02") + LAMP, 24, 0.4);
    double near = lit.at(0, 2, 0, 3.04);
    double far = lit.at(0, 2, 0, 3.2);
    assertThat(near).isLessThan(0.9 * far);
    assertThat(near).isPositive();
  }

  @Test
  void onAJointOfTwoFloorsBothHaveTheSameLight() throws Exception {
    String left = quad("0 0 4, 2 0 4, 2 0 0, 0 0 0", GREY);
    String right = quad("2 0 4, 4 0 4, 4 0 0, 2 0 0", GREY);
    String walls = room(0, 0, 0, 4, GREY).replace("4 5 1 0 -1", "");
    TexelLight lit =
        TexelLight.of(left + right + walls + "<PointLight location='1 3 1'/>", 16, 0.5);
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
    TexelLight one = with(1, scene);
    TexelLight four = with(4, scene);
    assertThat(one.pages().rays()).isEqualTo(four.pages().rays());
    for (int page = 0; page < one.irradiance().size(); page++) {
      assertThat(four.irradiance().get(page)).isEqualTo(one.irradiance().get(page));
    }
  }

  private static TexelLight with(int threads, String scene) throws Exception {
    ForkJoinPool pool = new ForkJoinPool(threads);
    try {
      return pool.submit(() -> TexelLight.of(scene, 8, 0.5)).get();
    } finally {
      pool.shutdown();
    }
  }

  @Test
  void whatIsCancelledHasTheLightOfThePatches() throws Exception {
    WorkProgress cancelled =
        new WorkProgress() {
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
    TexelLight lit = TexelLight.of(ROOM + LAMP, 12, 0.5, cancelled);
    assertThat(lit.pages().complete()).isFalse();
    double whole = TexelLight.of(ROOM + LAMP, 12, 0.5).at(0, 2, 0, 1);
    assertThat(lit.at(0, 2, 0, 1)).isCloseTo(whole, within(0.15 * whole));
  }
}
