package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.selectiverenderer.radiosity.TestScenes.room;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.radiosity.bake.ReinhardToneMapping;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.MonteCarloFormFactors;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.solve.RadiositySolver;
import org.selectiverenderer.radiosity.solve.SurfacePatches;

/** Eyes adapt to the colour of a room's light, in part. */
class ChromaticAdaptationTest {

  private static ReinhardToneMapping curve(String colour) throws Exception {
    RadiosityScene scene =
        TestScenes.read(
            room(0, 0, 0, 4, "diffuseColor='0.7 0.7 0.7'")
                + "<PointLight location='2 2 2' color='%s'/>".formatted(colour));
    MonteCarloFormFactors transport =
        MonteCarloFormFactors.find(
            scene, new SurfacePatches(scene, 1), 64, 16, 1, RadiosityProgress.NONE);
    RadiositySolution solution =
        new RadiositySolver(scene, transport).solve(20, 99, RadiosityProgress.NONE, each -> {});
    return ReinhardToneMapping.of(scene, solution, 0);
  }

  @Test
  void warmLightIsShownLessWarmAndAsBright() throws Exception {
    ReinhardToneMapping warm = curve("1 0.8 0.5");
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
    ReinhardToneMapping white = curve("1 1 1");

    assertThat(white.red()).isCloseTo(1, within(1e-6));
    assertThat(white.blue()).isCloseTo(1, within(1e-6));
  }
}
