package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.SmallScene.room;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.bake.ToneCurve;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.solve.LightPatches;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.solve.Solver;
import org.selectiverenderer.radiosity.solve.Transport;
import org.selectiverenderer.radiosity.work.WorkProgress;

/** Eyes adapt to the colour of a room's light, in part. */
class AdaptationTest {

  private static ToneCurve curve(String colour) throws Exception {
    LightScene scene =
        SmallScene.read(
            room(0, 0, 0, 4, "diffuseColor='0.7 0.7 0.7'")
                + "<PointLight location='2 2 2' color='%s'/>".formatted(colour));
    Transport transport =
        Transport.find(scene, new LightPatches(scene, 1), 64, 16, 1, WorkProgress.NONE);
    Solution solution = new Solver(scene, transport).solve(20, 99, WorkProgress.NONE, each -> {});
    return ToneCurve.of(scene, solution, 0);
  }

  @Test
  void warmLightIsShownLessWarmAndAsBright() throws Exception {
    ToneCurve warm = curve("1 0.8 0.5");
    double[] light = {Photometry.linear(1), Photometry.linear(0.8), Photometry.linear(0.5)};

    double redToBlue = warm.red() * light[0] / (warm.blue() * light[2]);

    assertThat(redToBlue).isGreaterThan(1.2).isLessThan(0.5 * light[0] / light[2]);
    assertThat(
            Photometry.luminance(
                warm.red() * light[0], warm.green() * light[1], warm.blue() * light[2]))
        .isCloseTo(Photometry.luminance(light[0], light[1], light[2]), within(0.01 * light[1]));
  }

  @Test
  void whiteLightIsLeftAlone() throws Exception {
    ToneCurve white = curve("1 1 1");

    assertThat(white.red()).isCloseTo(1, within(1e-6));
    assertThat(white.blue()).isCloseTo(1, within(1e-6));
  }
}
