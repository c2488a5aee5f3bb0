package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.radiosity.TestScenes.bins;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import org.junit.jupiter.api.Test;

/** Whose light a picture has of what is seen from both sides. */
class TwoSidedLightSelectorTest {
  private static final String GREY = "diffuseColor='0.735 0.735 0.735'";
  private static final String ROOM = room(0, 0, 0, 4, GREY);
  private static final String LAMP = "<PointLight location='0.5 2 2'/>";

  /**
   * The side away from the lamp is dark outside, though the lamp shines on it from inside. Wherever
   * its front is.
   */
  @Test
  void aBinHasTheLightOfItsOutsideAllAround() throws Exception {
    for (String bin : bins(GREY)) {
      TexelSceneFixture lit = TexelSceneFixture.of(bin + ROOM + LAMP, 40, 0.3);
      double[] sums = new double[4];
      lit.each(
          0,
          (p, lux) -> {
            int to = p[0] < 1.8501 ? 0 : p[0] > 2.1499 ? 2 : -1;
            if (to >= 0 && p[1] > 0.2) {
              sums[to] += lux;
              sums[to + 1]++;
            }
          });
      double towards = sums[0] / sums[1];
      double away = sums[2] / sums[3];
      assertThat(away).as(bin).isPositive().isLessThan(0.6 * towards);
    }
  }

  /** Outside of a room that is a sheet there is nobody, and no light. */
  @Test
  void aRoomHasTheLightOfItsInside() throws Exception {
    TexelSceneFixture lit =
        TexelSceneFixture.of(
            ROOM.replace("<IndexedFaceSet", "<IndexedFaceSet solid='false'") + LAMP, 8, 1);
    lit.each(0, (p, lux) -> assertThat(lux).isPositive());
  }

  /** A poster of one sheet that hangs with its front to the wall. */
  @Test
  void whatHangsBackToFrontHasTheLightOfTheSideThatIsSeen() throws Exception {
    String poster =
        quad("1 1 0.003, 1 2 0.003, 2 2 0.003, 2 1 0.003", GREY)
            .replace("<IndexedFaceSet", "<IndexedFaceSet solid='false'");
    TexelSceneFixture lit = TexelSceneFixture.of(poster + ROOM + LAMP, 16, 0.5);
    double wall = lit.at(0, 1.5, 1.5, 0.003);
    assertThat(wall).isPositive();
    lit.each(0, (p, lux) -> assertThat(lux).isGreaterThan(0.3 * wall));
  }
}
