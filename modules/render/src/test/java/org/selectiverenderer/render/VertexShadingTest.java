package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;

/** Light by vertex against light by pixel, which is held against the standard elsewhere. */
class VertexShadingTest {
  private static final String LAMP =
      "<PointLight DEF='L' location='0 0 2' attenuation='1 0 0.2' radius='100'/>";

  private static final String WALL =
      """
      <Transform DEF='T'><Shape>
        <Appearance><Material diffuseColor='0.8 0.8 0.8'/></Appearance>
        <IndexedFaceSet coordIndex='0 1 2 3 -1' solid='false'>
          <Coordinate point='-9 -9 0 9 -9 0 9 9 0 -9 9 0'/>
        </IndexedFaceSet>
      </Shape></Transform>
      """;

  @Test
  void whatDrawsDecidesWhereNobodyElseDoes() {
    GlInfo software = new GlInfo("Mesa", "llvmpipe (LLVM 15.0.6, 256 bits)", "4.5");
    GlInfo card = new GlInfo("NVIDIA Corporation", "NVIDIA H200/PCIe/SSE2", "4.6");
    assertThat(ShadingMode.AUTO.on(software)).isEqualTo(ShadingMode.VERTEX);
    assertThat(ShadingMode.AUTO.on(card)).isEqualTo(ShadingMode.PIXEL);
    assertThat(ShadingMode.PIXEL.on(software)).isEqualTo(ShadingMode.PIXEL);
    assertThat(ShadingMode.VERTEX.on(card)).isEqualTo(ShadingMode.VERTEX);
  }

  /** The mean absolute difference of two pictures' channels, in levels. */
  private static double difference(Screenshot a, Screenshot b) {
    long sum = 0;
    for (int y = 0; y < a.height(); y++) {
      for (int x = 0; x < a.width(); x++) {
        for (int shift = 0; shift < 24; shift += 8) {
          sum += Math.abs((a.rgb(x, y) >> shift & 0xff) - (b.rgb(x, y) >> shift & 0xff));
        }
      }
    }
    return sum / 3.0 / (a.width() * a.height());
  }

  private static Screenshot shoot(ShadingMode shading, TestScene scene, Camera camera) {
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      return studio.shoot(scene, camera, Background.BLACK, false, 0);
    }
  }

  @RequiresDisplay
  @ParameterizedTest
  @CsvSource({
    "scenes/trashcan.x3d, 3.6, -0.246, -2.3, 2.64",
    "scenes/trashcan.x3d, 4.4, -0.246, 0.135, 2.55",
    "scenes/apartment.x3d, 0.3, -0.25, -1.5, 0.6",
    "scenes/apartment.x3d, -4, -0.25, -1, 2.4",
    "scenes/practice.x3d, 0, 1.6, 4, 0"
  })
  void thePicturesOfAShippedSceneDifferByLessThanALevel(
      String file, double x, double y, double z, double turn) {
    TestScene scene = TestScene.load(Path.of(file));
    Camera camera =
        new Camera(
            new Matrix4d().rotateY(turn).translate(-x, -y, -z),
            new Matrix4d().setPerspective(0.9, 4.0 / 3, 0.05, 60),
            0,
            0,
            320,
            240);
    Screenshot byPixel = shoot(ShadingMode.PIXEL, scene, camera);
    Screenshot byVertex = shoot(ShadingMode.VERTEX, scene, camera);
    assertThat(difference(byPixel, byVertex)).isLessThan(1).isPositive();
  }

  @RequiresDisplay
  @Test
  void facesWithColoursAndImagesAreLitAlike() {
    String image = "<PixelTexture image='2 2 3 0xff0000 0x00ff00 0x0000ff 0xffffff'/>";
    String grey = "<PixelTexture image='2 1 1 0x40 0xff'/>";
    String look =
        "<Material diffuseColor='0.7 0.5 0.3' specularColor='0.4 0.4 0.4' shininess='0.1'"
            + " emissiveColor='0.1 0 0.1' transparency='0.2'/>";
    String face =
        """
        <Transform translation='%d -2 0' rotation='0 1 0 %s'><Shape>
          <Appearance>%s</Appearance>
          <IndexedFaceSet coordIndex='0 1 2 3 -1' solid='false'>
            <Coordinate point='-1 0 0 1 0 0 1 4 0 -1 4 0'/>%s
          </IndexedFaceSet></Shape></Transform>
        """;
    String colours = "<Color color='1 0 0 0 1 0 0 0 1 1 1 1'/>";
    TestScene scene =
        TestScene.of(
            "<PointLight location='1 2 3' radius='50'/>"
                + "<DirectionalLight direction='1 0 -1' intensity='0.4' ambientIntensity='0.5'/>"
                + face.formatted(-3, "0.3", look + image, "")
                + face.formatted(-1, "3.3", look + grey, "")
                + face.formatted(1, "0.3", look, colours)
                + face.formatted(3, "2.9", look, ""));
    Screenshot byPixel = shoot(ShadingMode.PIXEL, scene, TestImageRenderer.parallel());
    Screenshot byVertex = shoot(ShadingMode.VERTEX, scene, TestImageRenderer.parallel());
    assertThat(difference(byPixel, byVertex)).isLessThan(1);
  }

  private static final String PICTURE =
      "<Shape visible='false'><Appearance><PixelTexture DEF='P'"
          + " image='2 2 4 0xff000000 0x00ff00ff 0x0000ffff 0x808080ff'/></Appearance></Shape>";

  private static final String BAKED = "diffuseColor='0 0 0' emissiveColor='1 1 1'";

  /** As lit scenes have them: highlights alone, on a picture that is sent out. */
  private static String shining(double x, double y, String material, String more) {
    return """
        <Transform translation='%s %s 0'><Shape>
          <Appearance><Material ambientIntensity='0' specularColor='0.6 0.6 0.6'
              shininess='0.3' %s>
            <PixelTexture containerField='emissiveTexture' USE='P'/>%s
          </Material></Appearance><Sphere radius='0.9'/></Shape></Transform>
        """
        .formatted(x, y, material, more);
  }

  @RequiresDisplay
  @Test
  void picturesThatAreSentOutShineAlikeAndAreDrawnTogether() {
    String lamp = PICTURE + "<PointLight location='1 2 6' radius='50' ambientIntensity='0'/>";
    TestScene scene =
        TestScene.of(
            lamp
                + shining(-2, 1, BAKED, "").replaceFirst("<Sphere .*/>", "<Box size='.4 .4 .4'/>")
                + shining(-1, 1, BAKED, "").replaceFirst("<Sphere .*/>", "<Box size='.4 .4 .4'/>")
                + shining(1, 1, "diffuseColor='.3 .3 0' emissiveColor='1 1 1'", "")
                + shining(-2, -2, BAKED + " transparency='.5'", "")
                + shining(0, -2, "diffuseColor='0 0 0' emissiveColor='.5 1 .5'", ""));
    List<Screenshot> shots = new ArrayList<>();
    for (ShadingMode shading : List.of(ShadingMode.PIXEL, ShadingMode.VERTEX)) {
      try (TestImageRenderer studio = new TestImageRenderer(shading)) {
        shots.add(studio.shoot(scene));
        assertThat(studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel())).calls())
            .as("two small ones in one call, of the others each its own, %s", shading)
            .isEqualTo(4);
      }
    }
    assertThat(difference(shots.get(0), shots.get(1))).isLessThan(1).isPositive();
  }

  @RequiresDisplay
  @Test
  void picturesThatAreSentOutLookAsAmongOtherTextures() {
    String lamp = PICTURE + "<PointLight location='1 2 6' radius='50' ambientIntensity='0'/>";
    String white = "<PixelTexture containerField='specularTexture' image='1 1 3 0xffffff'/>";
    for (ShadingMode shading : List.of(ShadingMode.PIXEL, ShadingMode.VERTEX)) {
      Screenshot alone =
          shoot(
              shading, TestScene.of(lamp + shining(0, 0, BAKED, "")), TestImageRenderer.parallel());
      Screenshot among =
          shoot(
              shading,
              TestScene.of(lamp + shining(0, 0, BAKED, white)),
              TestImageRenderer.parallel());
      assertThat(difference(alone, among)).as("%s", shading).isLessThan(1);
      assertThat(
              difference(alone, shoot(shading, TestScene.of(lamp), TestImageRenderer.parallel())))
          .isGreaterThan(3);
    }
  }

  /** A picture at the beginning and after each change. */
  private static List<Screenshot> film(
      ShadingMode shading, String nodes, List<Consumer<TestScene>> changes) {
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      TestScene scene = TestScene.of(nodes);
      List<Screenshot> film = new ArrayList<>(List.of(studio.shoot(scene)));
      for (Consumer<TestScene> change : changes) {
        change.accept(scene);
        film.add(studio.shoot(scene));
      }
      return film;
    }
  }

  private static void assertAlike(String nodes, List<Consumer<TestScene>> changes) {
    List<Screenshot> byPixel = film(ShadingMode.PIXEL, nodes, changes);
    List<Screenshot> byVertex = film(ShadingMode.VERTEX, nodes, changes);
    for (int i = 0; i < byPixel.size(); i++) {
      assertThat(difference(byPixel.get(i), byVertex.get(i))).as("picture %d", i).isLessThan(1);
      if (i > 0) {
        assertThat(difference(byPixel.get(i - 1), byPixel.get(i))).isGreaterThan(1);
      }
    }
  }

  @RequiresDisplay
  @Test
  void whatMovesIsLitAsByPixelAllTheWay() {
    List<Consumer<TestScene>> changes = new ArrayList<>();
    for (int step = 1; step < 8; step++) {
      float[] back = {0, 0, -0.3f * step};
      float[] aside = {0.6f * step, 0, 2};
      changes.add(scene -> scene.set("T", "translation", back));
      changes.add(scene -> scene.set("L", "location", aside));
    }
    assertAlike(LAMP + WALL, changes);
  }

  @RequiresDisplay
  @Test
  void aLampThatIsSwitchedIsSeenInTheSameFrame() {
    List<Consumer<TestScene>> changes = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      boolean on = i % 2 == 0;
      changes.add(scene -> scene.set("L", "on", on));
    }
    assertAlike(LAMP.replace("/>", " on='false'/>") + WALL, changes);
  }

  @RequiresDisplay
  @Test
  void polygonsThatRefinementAddsAreNotCounted() {
    try (TestImageRenderer studio = new TestImageRenderer(ShadingMode.VERTEX)) {
      TestScene scene = TestScene.of(LAMP + WALL);
      studio.shoot(scene);
      assertThat(studio.renderer.items().get(0).mesh().indexCount()).isGreaterThan(100);
      assertThat(studio.renderer.cull(studio.gl(), List.of(TestImageRenderer.parallel())).indices())
          .isEqualTo(6);
    }
  }

  @RequiresDisplay
  @ParameterizedTest
  @CsvSource({"<Sphere/>", "<Box size='8 8 1'/>"})
  void aColourThatGoesOnChangingIsNotUploadedEachTime(String form) {
    try (TestImageRenderer studio = new TestImageRenderer(ShadingMode.VERTEX)) {
      TestScene scene =
          TestScene.of(
              LAMP + "<Shape><Appearance><Material DEF='M'/></Appearance>" + form + "</Shape>");
      for (int i = 0; i < 6; i++) {
        scene.set("M", "diffuseColor", new float[] {1, i / 100f, 0});
        studio.shoot(scene);
      }
      long uploads = studio.renderer.uploads();

      for (int i = 0; i < 20; i++) {
        scene.set("M", "diffuseColor", new float[] {1, 0, i / 100f});
        studio.shoot(scene);
      }

      assertThat(studio.renderer.uploads()).isEqualTo(uploads);
    }
  }

  @RequiresDisplay
  @ParameterizedTest
  @EnumSource(names = {"PIXEL", "VERTEX"})
  void whatMovesAmongManyLampsIsLitByThoseNearIt(ShadingMode shading) {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < 30; i++) {
      nodes.append("<PointLight radius='6' location='").append(20 * i).append(" 0 3'/>");
    }
    nodes.append(
        "<Transform DEF='T'><Shape><Appearance><Material/></Appearance><Box/></Shape></Transform>");
    try (TestImageRenderer studio = new TestImageRenderer(shading)) {
      TestScene scene = TestScene.of(nodes.toString());
      for (int i = 0; i < 30; i++) {
        scene.set("T", "translation", new float[] {20 * i, 0, 0});
        Camera camera =
            new Camera(
                new Matrix4d().translation(-20 * i, 0, -10),
                TestImageRenderer.parallel().projection(),
                0,
                0,
                TestImageRenderer.SIZE,
                TestImageRenderer.SIZE);
        Screenshot shot = studio.shoot(scene, camera, Background.BLACK, false, 0);
        assertThat(shot.rgb(32, 32) & 0xff).as("at lamp %d", i).isGreaterThan(100);
      }
    }
  }

  @RequiresDisplay
  @ParameterizedTest
  @CsvSource({"0 0 0", "1e-30 1e-30 1e-30", "1e30 1e30 1e30", "1 1 0", "-1 1 1"})
  void aScaleBeyondMeasureHarmsNothing(String scale) {
    String odd =
        "<Transform scale='%s'><Transform scale='%s'>%s%s</Transform></Transform>"
            .formatted(scale, scale, WALL, WALL)
            .replace("DEF='T'", "");
    String lamp = "<PointLight location='0 0 3'/>";
    String box = "<Transform translation='0 0 2'>" + WALL.replace('9', '1') + "</Transform>";
    for (ShadingMode shading : List.of(ShadingMode.PIXEL, ShadingMode.VERTEX)) {
      Screenshot shot =
          shoot(shading, TestScene.of(lamp + odd + box), TestImageRenderer.parallel());
      assertThat(shot.rgb(32, 32) & 0xff).isGreaterThan(100);
      assertThat(shoot(shading, TestScene.of(""), TestImageRenderer.parallel()).rgb(32, 32))
          .isZero();
    }
  }
}
