package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Matrix4d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.testing.RequiresDisplay;

/** Colours of the background at angles from the zenith. */
@RequiresDisplay
class BackgroundRendererTest {
  private static final Background BACKDROP =
      new Background(
          new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0},
          new float[] {0.5f, 1.0f},
          new float[] {0, 0, 0, 0, 0, 1},
          new float[] {1.0f},
          0);

  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();

  @ParameterizedTest
  @CsvSource({
    "0.25, 128, 0, 0",
    "0.5, 255, 0, 0",
    "0.75, 255, 128, 0",
    "1.2, 255, 255, 0",
    "2.0, 255, 255, 0",
    "2.3, 0, 0, 215",
    "2.64159, 0, 0, 128"
  })
  void theGradientHasItsColoursAtItsAngles(double angle, int red, int green, int blue) {
    // Looks at that angle from the zenith, leaning and from far away.
    Matrix4d view =
        new Matrix4d().rotateX(-(Math.PI / 2 - angle)).rotateY(0.7).translate(1000, 50, -3000);
    Camera camera = TestImageRenderer.perspective(view);
    int rgb = studio.shoot(TestScene.of("<Group/>"), camera, BACKDROP, false, 0).rgb(32, 32);
    // The pixel's centre lies half a pixel off the axis, which is 0.9 degrees.
    assertThat(rgb >> 16).isCloseTo(red, within(9));
    assertThat(rgb >> 8 & 0xff).isCloseTo(green, within(9));
    assertThat(rgb & 0xff).isCloseTo(blue, within(9));
  }
}
