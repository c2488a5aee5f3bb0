package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.VisibleSet;
import org.selectiverenderer.testing.RequiresDisplay;

/** Small lit shapes that differ in nothing but their diffuse colours. */
@RequiresDisplay
class DiffuseBatchTest {
  /** A square of one unit around a place, facing the viewer. */
  private static String square(double x, double y, String material) {
    return String.format(
        Locale.ROOT,
        "<Transform translation='%f %f 0'><Shape><Appearance><Material ambientIntensity='0' %s/>"
            + "</Appearance><IndexedFaceSet coordIndex='0 1 2 3 -1'>"
            + "<Coordinate point='-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0'/>"
            + "</IndexedFaceSet></Shape></Transform>",
        x,
        y,
        material);
  }

  /** What is seen of the square around a place. */
  private static int at(Screenshot shot, double x, double y) {
    return shot.rgb((int) (32 + 8 * x), (int) (32 + 8 * y));
  }

  @ParameterizedTest
  @EnumSource(names = {"VERTEX", "PIXEL"})
  void areDrawnTogetherEachInItsColour(ShadingMode shading) {
    TestScene scene =
        TestScene.of(
            square(-2, 0, "diffuseColor='1 0 0'")
                + square(0, 0, "diffuseColor='0 1 0'")
                + square(2, 0, "diffuseColor='.2 .4 .6'")
                + square(2, 2, "diffuseColor='1 0 0' emissiveColor='0 0 .2'")
                + square(-2, 2, "diffuseColor='0 .4 0' emissiveColor='0 0 .2'")
                + square(0, 2, "diffuseColor='1 0 0' specularColor='0 0 1'"));
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      Screenshot shot =
          studio.shoot(scene, TestImageRenderer.parallel(), Background.BLACK, true, 0);
      assertThat(studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel())).calls())
          .as("three plain ones, two that glow, one that shines")
          .isEqualTo(3);
      assertThat(List.of(at(shot, -2, 0), at(shot, 0, 0), at(shot, 2, 0)))
          .containsExactly(0xff0000, 0x00ff00, 0x336699);
      assertThat(List.of(at(shot, 2, 2), at(shot, -2, 2))).containsExactly(0xff0033, 0x006633);
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"VERTEX", "PIXEL"})
  void anotherColourTakesAShapeOutOfTheBatch(ShadingMode shading) {
    TestScene scene =
        TestScene.of(
            square(-2, 0, "DEF='M' diffuseColor='1 0 0'")
                + square(0, 0, "diffuseColor='0 1 0'")
                + square(2, 0, "diffuseColor='0 0 1'"));
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      studio.shoot(scene, TestImageRenderer.parallel(), Background.BLACK, true, 0);
      scene.set("M", "diffuseColor", new float[] {1, 1, 0});
      Screenshot shot =
          studio.shoot(scene, TestImageRenderer.parallel(), Background.BLACK, true, 0);
      assertThat(List.of(at(shot, -2, 0), at(shot, 0, 0), at(shot, 2, 0)))
          .containsExactly(0xffff00, 0x00ff00, 0x0000ff);
    }
  }

  @Test
  void areDrawnTogetherHoweverFinelyTheyAreDividedForTheirLight() {
    StringBuilder scene = new StringBuilder();
    for (int i = 0; i < 8; i++) {
      scene.append(octahedron(2 * (i % 4) - 3, 2 * (i / 4) - 1, 0.1 * i));
    }
    try (TestImageRenderer studio = new TestImageRenderer(ShadingMode.VERTEX)) {
      Screenshot shot =
          studio.shoot(
              TestScene.of(scene.toString()),
              TestImageRenderer.parallel(),
              Background.BLACK,
              true,
              0);
      VisibleSet seen = studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel()));
      assertThat(seen.shapes()).isEqualTo(8);
      assertThat(seen.calls()).as("2,000 triangles at their finest, 64 from afar").isEqualTo(1);
      assertThat(at(shot, -3, -1) & 0xff).isPositive().isLessThan(at(shot, 3, 1) & 0xff);
    }
  }

  /** Round in its normals, shining, with a share of blue. */
  private static String octahedron(double x, double y, double blue) {
    return String.format(
        Locale.ROOT,
        "<Transform translation='%f %f 0'><Shape><Appearance><Material diffuseColor='.5 .5 %f'"
            + " ambientIntensity='0' specularColor='.2 .2 .2' shininess='.8'/></Appearance>"
            + "<IndexedFaceSet creaseAngle='3.2' coordIndex='0 2 4 -1 2 1 4 -1 1 3 4 -1 3 0 4 -1"
            + " 2 0 5 -1 1 2 5 -1 3 1 5 -1 0 3 5 -1'><Coordinate point='.5 0 0 -.5 0 0 0 .5 0"
            + " 0 -.5 0 0 0 .5 0 0 -.5'/></IndexedFaceSet></Shape></Transform>",
        x,
        y,
        0.1 + blue);
  }
}
