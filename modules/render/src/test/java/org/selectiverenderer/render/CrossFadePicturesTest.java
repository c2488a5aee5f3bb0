package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.VisibleSet;
import org.selectiverenderer.testing.RequiresDisplay;

/** Pictures of versions that give way to others. */
@RequiresDisplay
class CrossFadePicturesTest {
  private static final int SIZE = TestImageRenderer.SIZE;

  private static final String SPHERE =
      "<Transform translation='0.3 0.2 0'><Shape><Appearance>%s</Appearance>"
          + "<Sphere radius='2.5'/></Shape></Transform>";

  private static final String BOX = "<Shape><Appearance>%s</Appearance><Box size='4 3 2'/></Shape>";

  private static final String RED = "<Material diffuseColor='1 0 0'/>";
  private static final String BLUE = "<Material diffuseColor='0 0 1'/>";

  /** Stands half in front of the versions. */
  private static final String POST =
      "<Transform translation='-1.5 0 3'><Shape><Appearance>"
          + "<UnlitMaterial emissiveColor='1 1 1'/></Appearance><Box size='1 6 1'/>"
          + "</Shape></Transform><DirectionalLight direction='-1 -1 -1'/>";

  private static TestScene scene(String first, String second) {
    return TestScene.of("<Switch DEF='S' whichChoice='0'>" + first + second + "</Switch>" + POST);
  }

  private static TestScene scene() {
    return scene(SPHERE.formatted(RED), BOX.formatted(BLUE));
  }

  private static void change(TestScene scene, int from, int to) {
    Node node = scene.loaded().scene().find("S").orElseThrow();
    scene.tree().fades().begin(node, from, to, 1);
    scene.set("S", "whichChoice", to);
  }

  private static Screenshot shoot(TestImageRenderer studio, TestScene scene, double time) {
    scene.tree().fades().at(time);
    return studio.shoot(scene);
  }

  /** Checks that every pixel is that of one of two pictures; returns the share of the second. */
  private static double share(Screenshot shot, Screenshot first, Screenshot second) {
    int differing = 0;
    int ofSecond = 0;
    for (int y = 0; y < SIZE; y++) {
      for (int x = 0; x < SIZE; x++) {
        int rgb = shot.rgb(x, y);
        assertThat(rgb).as("pixel %s %s", x, y).isIn(first.rgb(x, y), second.rgb(x, y));
        if (first.rgb(x, y) != second.rgb(x, y)) {
          differing++;
          ofSecond += rgb == second.rgb(x, y) ? 1 : 0;
        }
      }
    }
    assertThat(differing).isGreaterThan(500);
    return ofSecond / (double) differing;
  }

  private static void assertSame(Screenshot one, Screenshot other) {
    assertThat(Arrays.equals(one.rgba(), other.rgba())).as("the same picture").isTrue();
  }

  @ParameterizedTest
  @CsvSource({"PIXEL, 0.25", "PIXEL, 0.5", "VERTEX, 0.5", "VERTEX, 0.75"})
  void everyPixelIsOfOneVersionAndTheShareIsTheTimes(ShadingMode shading, double time) {
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      TestScene scene = scene();
      Screenshot before = studio.shoot(scene);
      change(scene, 0, 1);
      assertSame(shoot(studio, scene, 0), before);
      Screenshot during = shoot(studio, scene, time);
      Screenshot after = shoot(studio, scene, 1);
      assertThat(share(during, before, after)).isBetween(time - 0.05, time + 0.05);
      scene.set("S", "whichChoice", 0);
      assertSame(studio.shoot(scene), before);
      scene.set("S", "whichChoice", 1);
      assertSame(studio.shoot(scene), after);
    }
  }

  @Test
  void aVersionFadesInWhereThereWasNone() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene = scene();
      scene.set("S", "whichChoice", -1);
      Screenshot before = studio.shoot(scene);
      change(scene, -1, 1);
      Screenshot during = shoot(studio, scene, 0.5);
      Screenshot after = shoot(studio, scene, 2);
      assertThat(share(during, before, after)).isBetween(0.45, 0.55);
    }
  }

  @Test
  void transparentVersionsFadeWithoutBeingMixedWithEachOther() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene =
          scene(
              SPHERE.formatted("<Material transparency='0.5' diffuseColor='1 0 0'/>"),
              BOX.formatted("<Material transparency='0.5' diffuseColor='0 0 1'/>"));
      Screenshot before = studio.shoot(scene);
      change(scene, 0, 1);
      Screenshot during = shoot(studio, scene, 0.5);
      Screenshot after = shoot(studio, scene, 1);
      assertThat(share(during, before, after)).isBetween(0.45, 0.55);
    }
  }

  @Test
  void theShadersOfAuthorsFadeToo() {
    String green =
        BLUE
            + "<ComposedShader language='GLSL'>"
            + "<ShaderPart type='VERTEX'>void main() { gl_Position = ftransform(); }</ShaderPart>"
            + "<ShaderPart type='FRAGMENT'>void main() { gl_FragColor = vec4(0, 1, 0, 1); }"
            + "</ShaderPart></ComposedShader>";
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene = scene(SPHERE.formatted(RED), BOX.formatted(green));
      Screenshot before = studio.shoot(scene);
      change(scene, 0, 1);
      Screenshot during = shoot(studio, scene, 0.5);
      Screenshot after = shoot(studio, scene, 1);
      assertThat(share(during, before, after)).isBetween(0.45, 0.55);
    }
  }

  /** Small shapes that share a batch, of which some fade and others stay. */
  @Test
  void theRestOfABatchStays() {
    String red = "<Shape><Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance>%s</Shape>";
    String square =
        red.formatted(
            "<IndexedFaceSet coordIndex='0 1 2 3 -1'>"
                + "<Coordinate point='-1.5 -1.5 0 1.5 -1.5 0 1.5 1.5 0 -1.5 1.5 0'/>"
                + "</IndexedFaceSet>");
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene =
          TestScene.of(
              "<Switch DEF='S' whichChoice='0'><Transform translation='-1.6 0 0'>"
                  + square
                  + "</Transform><Transform translation='-1.6 2 0'>"
                  + square
                  + "</Transform></Switch><Transform translation='1.6 0 0'>"
                  + square
                  + "</Transform>");
      Screenshot before = studio.shoot(scene);
      change(scene, 0, 1);
      Screenshot during = shoot(studio, scene, 0.5);
      Screenshot after = shoot(studio, scene, 1);
      assertThat(during.rgb(45, 32)).isEqualTo(0xff0000);
      int differing = 0;
      for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
          assertThat(during.rgb(x, y)).isIn(before.rgb(x, y), after.rgb(x, y));
          differing += during.rgb(x, y) == before.rgb(x, y) ? 0 : 1;
        }
      }
      assertThat(differing).isGreaterThan(100);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 4})
  void bothEyesSeeTheSamePattern(int samples) {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene = scene();
      studio.shoot(scene);
      change(scene, 0, 1);
      scene.tree().fades().at(0.5);
      Camera left = TestImageRenderer.parallel();
      Camera right =
          new Camera(left.view(), left.projection(), SIZE + 3, 5, left.width(), left.height());
      Screenshot one = studio.shoot(scene, left, Background.BLACK, false, samples);
      Screenshot other = studio.shoot(scene, right, Background.BLACK, false, samples);
      for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
          assertThat(other.rgb(x + SIZE + 3, y + 5)).isEqualTo(one.rgb(x, y));
        }
      }
    }
  }

  @Test
  void aChangeBackGoesBackFromWhereItHadCome() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene = scene();
      Screenshot before = studio.shoot(scene);
      change(scene, 0, 1);
      Screenshot quarter = shoot(studio, scene, 0.25);
      change(scene, 1, 0);
      assertSame(shoot(studio, scene, 0.25), quarter);
      assertSame(shoot(studio, scene, 0.5), before);
      assertThat(scene.tree().fades().versions()).isEmpty();
    }
  }

  @Test
  void whatIsCountedFollowsTheNewVersionAndWhatIsDrawnHasBoth() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene = scene();
      long sphere = drawn(studio, scene).indices() / 3;
      change(scene, 0, 1);
      scene.tree().fades().at(0.5);
      assertThat(scene.tree().shownPolygons()).isEqualTo(12 + 12);
      VisibleSet seen = drawn(studio, scene);
      assertThat(seen.shapes()).isEqualTo(3);
      assertThat(seen.indices() / 3).isGreaterThan(sphere);
    }
  }

  private static VisibleSet drawn(TestImageRenderer studio, TestScene scene) {
    studio.renderer.prepare(studio.gl(), scene.tree());
    return studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel()));
  }

  @Test
  void aFadeEndsWithTheObject() {
    try (TestImageRenderer studio = new TestImageRenderer()) {
      TestScene scene =
          TestScene.of(
              "<Group DEF='G'><Switch DEF='S' whichChoice='0'>"
                  + SPHERE.formatted(RED)
                  + BOX.formatted(BLUE)
                  + "</Switch></Group>"
                  + POST);
      studio.shoot(scene);
      change(scene, 0, 1);
      scene.set("G", "children", List.of());
      shoot(studio, scene, 0.5);
      assertThat(scene.tree().fades().versions()).isEmpty();
    }
  }
}
