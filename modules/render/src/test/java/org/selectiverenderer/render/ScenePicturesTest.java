package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;

@RequiresDisplay
class ScenePicturesTest {
  @AutoClose private final TestImageRenderer studio = new TestImageRenderer();

  /** A square of two by two units in the plane z = 0, its corner at the origin. */
  private static String square(String appearance, String more) {
    return """
    <Shape>
      <Appearance>%s</Appearance>
      <IndexedFaceSet coordIndex='0 1 2 3 -1' texCoordIndex='0 1 2 3 -1' %s
        <Coordinate point='0 0 0 2 0 0 2 2 0 0 2 0'/>
        <TextureCoordinate point='0 0 1 0 1 1 0 1'/>
      </IndexedFaceSet>
    </Shape>
    """
        .formatted(appearance, more.isEmpty() ? ">" : more);
  }

  private static final String RED = "<UnlitMaterial emissiveColor='1 0 0'/>";

  private Screenshot shoot(String nodes) {
    return studio.shoot(TestScene.of(nodes));
  }

  private static int count(Screenshot shot, int rgb) {
    int count = 0;
    for (int y = 0; y < shot.height(); y++) {
      for (int x = 0; x < shot.width(); x++) {
        count += shot.rgb(x, y) == rgb ? 1 : 0;
      }
    }
    return count;
  }

  @Test
  void anUnlitSquareFillsExactlyItsPixels() {
    Screenshot shot = shoot(square(RED, ""));
    assertThat(count(shot, 0xff0000)).isEqualTo(16 * 16);
    assertThat(count(shot, 0)).isEqualTo(64 * 64 - 16 * 16);
    assertThat(shot.rgb(32, 32)).isEqualTo(0xff0000);
    assertThat(shot.rgb(47, 47)).isEqualTo(0xff0000);
  }

  @Test
  void theBackOfASolidFaceIsNotDrawn() {
    String turned = "<Transform rotation='0 1 0 3.14159265'>%s</Transform>";
    assertThat(count(shoot(turned.formatted(square(RED, ""))), 0xff0000)).isZero();
    assertThat(count(shoot(turned.formatted(square(RED, "solid='false'>"))), 0xff0000))
        .isEqualTo(16 * 16);
  }

  @Test
  void aMirroredSolidFaceIsStillSeenFromItsFront() {
    String mirrored = "<Transform scale='-1 1 1'>" + square(RED, "") + "</Transform>";
    assertThat(count(shoot(mirrored), 0xff0000)).isEqualTo(16 * 16);
  }

  @Test
  void theFirstRowOfAPixelTextureIsItsLowest() {
    Screenshot shot =
        shoot(
            square(
                "<UnlitMaterial/><PixelTexture repeatS='false' repeatT='false'"
                    + " image='2 2 3 0xff0000 0x00ff00 0x0000ff 0xffffff'/>",
                ""));
    assertThat(shot.rgb(33, 33)).isEqualTo(0xff0000);
    assertThat(shot.rgb(46, 33)).isEqualTo(0x00ff00);
    assertThat(shot.rgb(33, 46)).isEqualTo(0x0000ff);
    assertThat(shot.rgb(46, 46)).isEqualTo(0xffffff);
  }

  @Test
  void aGreyTextureTintsAndAColourTextureReplacesBeforeX3d4() {
    String grey = square(RED + "<PixelTexture image='1 1 1 0x80'/>", "");
    String pink = square(RED + "<PixelTexture image='1 1 3 0x8000ff'/>", "");
    assertThat(studio.shoot(TestScene.of("3.3", grey)).rgb(40, 40)).isEqualTo(0x800000);
    assertThat(studio.shoot(TestScene.of("3.3", pink)).rgb(40, 40)).isEqualTo(0x8000ff);
    assertThat(shoot(grey).rgb(40, 40)).isEqualTo(0x800000);
    assertThat(shoot(pink).rgb(40, 40)).isEqualTo(0x800000);
  }

  @Test
  void aTextureTransformMovesTheImage() {
    Screenshot shot =
        shoot(
            square(
                "<UnlitMaterial/><PixelTexture image='2 1 3 0xff0000 0x00ff00'/>"
                    + "<TextureTransform translation='0.5 0'/>",
                ""));
    // Between the two pixels' centres colours are mixed; here, near one, nearly pure.
    assertThat(shot.rgb(36, 40) >> 8 & 0xff).isGreaterThan(200);
    assertThat(shot.rgb(43, 40) >> 16).isGreaterThan(200);
  }

  @Test
  void vertexColoursReplaceTheMaterialsAndAreInterpolated() {
    Screenshot shot =
        shoot(
            """
            <Shape><Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance>
              <IndexedFaceSet coordIndex='0 1 2 3 -1'>
                <Coordinate point='0 0 0 2 0 0 2 2 0 0 2 0'/>
                <Color color='0 0 1 0 1 0 0 1 0 0 0 1'/>
              </IndexedFaceSet>
            </Shape>\
            """);
    int middle = shot.rgb(40, 40);
    assertThat(middle >> 16).isZero();
    assertThat(middle >> 8 & 0xff).isCloseTo(0x88, org.assertj.core.data.Offset.offset(2));
  }

  @Test
  void aTransparentSquareIsBlendedOverWhatIsBehindWhateverTheOrder() {
    String glass = "<UnlitMaterial emissiveColor='0 0 1' transparency='0.25'/>";
    String front = "<Transform translation='0 0 1'>" + square(glass, "") + "</Transform>";
    int expected = 0x4000bf;
    assertThat(shoot(front + square(RED, "")).rgb(40, 40)).isEqualTo(expected);
    assertThat(shoot(square(RED, "") + front).rgb(40, 40)).isEqualTo(expected);
  }

  @Test
  void transparentSquaresAreBlendedBackToFront() {
    String blue = square("<UnlitMaterial emissiveColor='0 0 1' transparency='0.5'/>", "");
    String green = square("<UnlitMaterial emissiveColor='0 1 0' transparency='0.5'/>", "");
    String scene =
        "<Transform translation='0 0 %d'>"
            + blue
            + "</Transform>"
            + "<Transform translation='0 0 %d'>"
            + green
            + "</Transform>";
    assertThat(shoot(scene.formatted(1, 2)).rgb(40, 40)).isEqualTo(0x008040);
    assertThat(shoot(scene.formatted(2, 1)).rgb(40, 40)).isEqualTo(0x004080);
  }

  @Test
  void holesOfACutOutTextureShowWhatIsBehind() {
    String leaf =
        square(
            "<UnlitMaterial/><PixelTexture repeatS='false' repeatT='false'"
                + " image='2 1 4 0x00ff00ff 0x00ff0000'/>",
            "");
    Screenshot shot =
        shoot("<Transform translation='0 0 1'>" + leaf + "</Transform>" + square(RED, ""));
    assertThat(shot.rgb(33, 40)).isEqualTo(0x00ff00);
    assertThat(shot.rgb(46, 40)).isEqualTo(0xff0000);
  }

  @Test
  void aSwitchShowsItsOtherVersionWithoutAnUpload() {
    TestScene scene =
        TestScene.of(
            "<Switch DEF='S' whichChoice='0'>"
                + square(RED, "")
                + square("<UnlitMaterial emissiveColor='0 1 0'/>", "")
                + "</Switch>");
    assertThat(studio.shoot(scene).rgb(40, 40)).isEqualTo(0xff0000);
    long before = studio.renderer.uploads();
    scene.set("S", "whichChoice", 1);
    assertThat(studio.shoot(scene).rgb(40, 40)).isEqualTo(0x00ff00);
    assertThat(studio.renderer.uploads()).isEqualTo(before).isEqualTo(2);
  }

  @Test
  void aMeshThatTwoShapesUseIsUploadedOnce() {
    studio.shoot(
        TestScene.of(
            "<Shape><Box DEF='B'/></Shape>"
                + "<Transform translation='3 0 0'><Shape><Box USE='B'/></Shape></Transform>"));
    assertThat(studio.renderer.uploads()).isEqualTo(1);
  }

  @Test
  void aMaterialThatChangesIsSeenAtTheNextFrame() {
    TestScene scene = TestScene.of(square("<UnlitMaterial DEF='M' emissiveColor='1 0 0'/>", ""));
    assertThat(studio.shoot(scene).rgb(40, 40)).isEqualTo(0xff0000);
    scene.set("M", "emissiveColor", new float[] {0, 0, 1});
    assertThat(studio.shoot(scene).rgb(40, 40)).isEqualTo(0x0000ff);
  }

  @Test
  void farFromTheOriginNothingJitters() {
    String far = "<Transform translation='10000000 0 0'>" + square(RED, "") + "</Transform>";
    Camera near = TestImageRenderer.parallel();
    Camera camera =
        new Camera(
            near.view().translate(-10000000, 0, 0, new org.joml.Matrix4d()),
            near.projection(),
            0,
            0,
            64,
            64);
    Screenshot shot = studio.shoot(TestScene.of(far), camera, Background.BLACK, false, 0);
    assertThat(count(shot, 0xff0000)).isEqualTo(16 * 16);
  }

  @Test
  void linesAndPointsShowTheirColours() {
    Screenshot shot =
        shoot(
            """
            <Shape><Appearance><Material emissiveColor='1 1 0'/></Appearance>
              <IndexedLineSet coordIndex='0 1 -1'>
                <Coordinate point='-3 0.0625 0 3 0.0625 0'/></IndexedLineSet></Shape>
            <Shape><PointSet><Coordinate point='0 2 0'/><Color color='0 1 1'/></PointSet></Shape>
            """);
    assertThat(shot.rgb(20, 32)).isEqualTo(0xffff00);
    assertThat(shot.rgb(31, 47)).isEqualTo(0x00ffff);
    assertThat(count(shot, 0x00ffff)).isEqualTo(4);
  }

  @Test
  void severalSamplesSmoothAnEdge() {
    String leaning = "<Transform rotation='0 0 1 0.3'>" + square(RED, "") + "</Transform>";
    TestScene scene = TestScene.of(leaning);
    Screenshot hard = studio.shoot(scene);
    Screenshot soft = studio.shoot(scene, TestImageRenderer.parallel(), Background.BLACK, false, 4);
    assertThat(count(hard, 0xff0000) + count(hard, 0)).isEqualTo(64 * 64);
    assertThat(count(soft, 0xff0000) + count(soft, 0)).isLessThan(64 * 64 - 20);
  }

  @Test
  void aViewportLeavesTheRestAlone() {
    Camera whole = TestImageRenderer.parallel();
    Camera right = new Camera(whole.view(), whole.projection(), 64, 0, 64, 64);
    Screenshot shot = studio.shoot(TestScene.of(square(RED, "")), right, white(), false, 0);
    assertThat(shot.rgb(64 + 40, 40)).isEqualTo(0xff0000);
    assertThat(shot.rgb(64, 0)).isEqualTo(0xffffff);
    assertThat(shot.rgb(40, 40)).isNotEqualTo(0xff0000);
    assertThat(shot.rgb(63, 0)).isNotEqualTo(0xffffff);
  }

  private static Background white() {
    float[] none = {};
    return new Background(new float[] {1, 1, 1}, none, none, none, 0);
  }
}
