package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.draw.VisibleSet;
import org.selectiverenderer.testing.RequiresDisplay;

@RequiresDisplay
class DrawBatchTest {
  private static final String RED =
      "<Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance>";

  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();

  /** A square of one unit around a place, in a Transform of that name, red. */
  private static String square(String name, double x, double y) {
    return square(name, x, y, RED);
  }

  private static String square(String name, double x, double y, String appearance) {
    return String.format(
        Locale.ROOT,
        "<Transform DEF='%s' translation='%f %f 0'><Shape>%s<IndexedFaceSet coordIndex='0 1 2 3 -1'>"
            + "<Coordinate point='-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0'/>"
            + "</IndexedFaceSet></Shape></Transform>",
        name,
        x,
        y,
        appearance);
  }

  private VisibleSet visible(TestScene scene) {
    studio.renderer.prepare(studio.gl(), scene.tree());
    return studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel()));
  }

  /** What is seen of the square around a place. */
  private static int at(Screenshot shot, double x, double y) {
    return shot.rgb((int) (32 + 8 * x), (int) (32 + 8 * y));
  }

  @Test
  void smallShapesOfOneLookAreOneCallAndOneUpload() {
    TestScene scene = TestScene.of(square("A", -2, 0) + square("B", 0, 0) + square("C", 2, 0));

    VisibleSet seen = visible(scene);

    assertThat(seen.shapes()).isEqualTo(3);
    assertThat(seen.calls()).isEqualTo(1);
    assertThat(studio.renderer.uploads()).isEqualTo(1);
  }

  @Test
  void whatLooksOtherwiseIsAnotherCall() {
    String green = "<Appearance><UnlitMaterial emissiveColor='0 1 0'/></Appearance>";
    String glass = "<Appearance><Material transparency='0.5'/></Appearance>";
    TestScene scene =
        TestScene.of(
            square("A", -2, 0)
                + square("B", 0, 0, green)
                + square("C", 2, 0, glass)
                + square("D", 2, 2, glass)
                + square("E", -2, 2)
                + "<Group><PointLight global='false'/>"
                + square("F", 0, 2, "<Appearance><Material/></Appearance>")
                + "</Group>"
                + square("G", 0, -2, "<Appearance><Material/></Appearance>"));

    assertThat(visible(scene).calls()).as("A and E; B; C; D; F; G").isEqualTo(6);
  }

  @Test
  void aSwitchInABatchShowsItsOtherVersionWithoutAnUpload() {
    TestScene scene =
        TestScene.of(
            "<Switch DEF='S' whichChoice='0'>"
                + square("A", -2, 0)
                + square("B", 2, 0)
                + "</Switch>"
                + square("C", 0, 2));
    Screenshot before = studio.shoot(scene);
    assertThat(at(before, -2, 0)).isEqualTo(0xff0000);
    assertThat(at(before, 2, 0)).isZero();
    long uploads = studio.renderer.uploads();

    scene.set("S", "whichChoice", 1);
    Screenshot after = studio.shoot(scene);

    assertThat(at(after, -2, 0)).isZero();
    assertThat(at(after, 2, 0)).isEqualTo(0xff0000);
    assertThat(at(after, 0, 2)).isEqualTo(0xff0000);
    assertThat(studio.renderer.uploads()).isEqualTo(uploads).isEqualTo(1);
    assertThat(visible(scene).calls()).isEqualTo(1);
  }

  @Test
  void aShapeThatMovesLeavesItsBatchInTheSameFrameAndTheOthersStay() {
    TestScene scene = TestScene.of(square("A", -2, 0) + square("B", 0, 0) + square("C", 2, 0));
    studio.shoot(scene);

    scene.set("B", "translation", new float[] {0, 2, 0});
    Screenshot shot = studio.shoot(scene);

    assertThat(at(shot, 0, 0)).isZero();
    assertThat(at(shot, 0, 2)).isEqualTo(0xff0000);
    assertThat(at(shot, -2, 0)).isEqualTo(0xff0000);
    assertThat(at(shot, 2, 0)).isEqualTo(0xff0000);
    assertThat(studio.renderer.uploads()).as("the batch, then B's mesh").isEqualTo(2);
    scene.set("B", "translation", new float[] {0, -2, 0});
    assertThat(at(studio.shoot(scene), 0, -2)).isEqualTo(0xff0000);
    assertThat(studio.renderer.uploads()).isEqualTo(2);
    assertThat(visible(scene).calls()).isEqualTo(2);
  }

  @Test
  void aMaterialThatChangesTakesItsShapesOutOfTheirBatch() {
    String named = "<Appearance><UnlitMaterial DEF='M' emissiveColor='1 0 0'/></Appearance>";
    TestScene scene =
        TestScene.of(square("A", -2, 0, named) + square("B", 0, 0) + square("C", 2, 0));
    studio.shoot(scene);

    scene.set("M", "emissiveColor", new float[] {0, 0, 1});
    Screenshot shot = studio.shoot(scene);

    assertThat(at(shot, -2, 0)).isEqualTo(0x0000ff);
    assertThat(at(shot, 0, 0)).isEqualTo(0xff0000);
    assertThat(at(shot, 2, 0)).isEqualTo(0xff0000);
  }

  @Test
  void aLookThatNothingHasAnyMoreIsForgotten() {
    String named = "<Appearance><UnlitMaterial DEF='M' emissiveColor='1 0 0'/></Appearance>";
    TestScene scene = TestScene.of(square("A", -2, 0, named) + square("B", 0, 0));
    scene.set("M", "emissiveColor", new float[] {0, 0, 1});
    studio.shoot(scene);
    float[] blue = studio.renderer.items().get(0).numbers();
    scene.set("M", "emissiveColor", new float[] {0, 1, 0});
    studio.shoot(scene);

    scene.set("M", "emissiveColor", new float[] {0, 0, 1});
    studio.shoot(scene);

    assertThat(studio.renderer.items().get(0).numbers()).isEqualTo(blue).isNotSameAs(blue);
  }

  @Test
  void aSwitchThatHoldsALampUploadsNothing() {
    String white = "<Appearance><Material/></Appearance>";
    TestScene scene =
        TestScene.of(
            "<Switch DEF='S' whichChoice='0'><PointLight location='0 0 3'/></Switch>"
                + square("A", -2, 0, white)
                + square("B", 2, 0, white)
                + square("C", 0, 2));
    Screenshot before = studio.shoot(scene);
    assertThat(at(before, -2, 0)).isNotZero();
    long uploads = studio.renderer.uploads();

    scene.set("S", "whichChoice", -1);

    assertThat(at(studio.shoot(scene), -2, 0)).isZero();
    assertThat(studio.renderer.uploads()).isEqualTo(uploads);
    scene.set("S", "whichChoice", 0);
    assertThat(studio.shoot(scene).rgba()).isEqualTo(before.rgba());
    assertThat(studio.renderer.uploads()).isEqualTo(uploads);
  }

  @Test
  void aLampThatMovesLeavesWhatIsNotLitInItsBatch() {
    TestScene scene =
        TestScene.of(
            "<Transform DEF='T'><PointLight/></Transform>"
                + square("A", -2, 0)
                + square("B", 0, 0));
    assertThat(visible(scene).calls()).isEqualTo(1);

    scene.set("T", "translation", new float[] {0, 2, 0});

    assertThat(visible(scene).calls()).isEqualTo(1);
    assertThat(studio.renderer.uploads()).isEqualTo(1);
  }

  @Test
  void aLampThatHasMovedLightsBatchesAgain() {
    String white = "<Appearance><Material/></Appearance>";
    TestScene scene =
        TestScene.of(
            "<Transform DEF='T'><PointLight location='0 0 3'/></Transform>"
                + square("A", -2, 0, white)
                + square("B", 0, 0, white));
    assertThat(visible(scene).calls()).isEqualTo(1);
    Screenshot before = studio.shoot(scene);

    scene.set("T", "translation", new float[] {2, 0, 0});

    assertThat(at(studio.shoot(scene), -2, 0)).isLessThan(at(before, -2, 0));
    assertThat(visible(scene).calls()).isEqualTo(1);
  }

  @Test
  void aShapeThatGoesLeavesTheOthersAsTheyAre() {
    TestScene scene =
        TestScene.of(
            "<Group DEF='G'>"
                + square("A", -2, 0)
                + "</Group>"
                + square("B", 0, 0)
                + square("C", 2, 0));
    studio.shoot(scene);

    scene.set("G", "children", List.of());
    Screenshot shot = studio.shoot(scene);

    assertThat(at(shot, -2, 0)).isZero();
    assertThat(at(shot, 0, 0)).isEqualTo(0xff0000);
    assertThat(at(shot, 2, 0)).isEqualTo(0xff0000);
    assertThat(studio.renderer.uploads()).isEqualTo(1);
  }

  @Test
  void farFromTheOriginABatchFillsExactlyItsPixels() {
    TestScene scene =
        TestScene.of(
            "<Transform translation='10000000 0 0'>"
                + square("A", -2, 0)
                + square("B", 2, 0)
                + "</Transform>");
    Camera near = TestImageRenderer.parallel();
    Camera camera =
        new Camera(
            near.view().translate(-10000000, 0, 0, new Matrix4d()),
            near.projection(),
            0,
            0,
            64,
            64);

    Screenshot shot = studio.shoot(scene, camera, Background.BLACK, false, 0);

    assertThat(studio.renderer.uploads()).isEqualTo(1);
    int red = 0;
    for (int y = 0; y < 64; y++) {
      for (int x = 0; x < 64; x++) {
        red += shot.rgb(x, y) == 0xff0000 ? 1 : 0;
      }
    }
    assertThat(red).isEqualTo(2 * 8 * 8);
  }

  @Test
  void whatIsTooFarApartForFloatsIsNotPutTogether() {
    TestScene scene = TestScene.of(square("A", 0, 0) + square("B", 100_000, 0));

    studio.renderer.prepare(studio.gl(), scene.tree());

    assertThat(studio.renderer.uploads()).isEqualTo(2);
  }

  /**
   * Lit shapes in many places, some mirrored, some seen from both sides.
   *
   * @param allInBatches else a shininess, which shows nowhere, makes each look its own
   */
  private static TestScene clutter(boolean allInBatches) {
    Random random = new Random(11);
    StringBuilder nodes =
        new StringBuilder("<DirectionalLight direction='-1 -2 -3' ambientIntensity='0.3'/>");
    String[] forms = {"<Box size='1 2 1.5'/>", "<Cone/>", "<Cylinder solid='false'/>"};
    for (int i = 0; i < 60; i++) {
      nodes.append(
          String.format(
              Locale.ROOT,
              "<Transform translation='%f %f %f' scale='%f 0.7 1' rotation='1 2 3 %f'><Shape>"
                  + "<Appearance><Material diffuseColor='%s 0.6 0.2' shininess='%f'/></Appearance>"
                  + "%s</Shape></Transform>",
              random.nextDouble(-6, 6),
              random.nextDouble(-6, 6),
              random.nextDouble(-6, 6),
              i % 4 == 0 ? -1 : 0.8,
              random.nextDouble(6),
              i % 2 == 0 ? "0.9" : "0.2",
              allInBatches ? 0.2 : 0.2 + i / 100.0,
              forms[i % forms.length]));
    }
    return TestScene.of(nodes.toString());
  }

  @Test
  void picturesOfBatchesAreThoseOfTheirShapes() {
    List<byte[]> batches = pictures(clutter(true));
    assertThat(calls()).isLessThan(20);
    List<byte[]> single = pictures(clutter(false));
    assertThat(calls()).isGreaterThan(40);

    for (int i = 0; i < batches.size(); i++) {
      int differing = 0;
      for (int at = 0; at < batches.get(i).length; at++) {
        int difference = (batches.get(i)[at] & 0xff) - (single.get(i)[at] & 0xff);
        differing += Math.abs(difference) > 2 ? 1 : 0;
      }
      // An edge may pass on the other side of a pixel's middle.
      assertThat(differing).isLessThan(batches.get(i).length / 500);
    }
  }

  private List<byte[]> pictures(TestScene scene) {
    Random random = new Random(2);
    return Stream.generate(
            () -> new Vector3d(random.nextDouble(-9, 9), random.nextDouble(-9, 9), 12))
        .limit(10)
        .map(eye -> new Matrix4d().lookAt(eye, new Vector3d(), new Vector3d(0, 1, 0)))
        .map(
            view ->
                studio
                    .shoot(scene, TestImageRenderer.perspective(view), Background.BLACK, false, 0)
                    .rgba())
        .toList();
  }

  private int calls() {
    Matrix4d all = new Matrix4d().setOrtho(-99, 99, -99, 99, -99, 99);
    return studio
        .renderer
        .cull(studio.gl(), List.of(new Camera(new Matrix4d(), all, 0, 0, 64, 64)))
        .calls();
  }
}
