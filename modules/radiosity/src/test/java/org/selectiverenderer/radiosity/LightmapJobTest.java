package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Scene files to lit scene files whose light is in pictures. */
class LightmapJobTest {
  private static final String GREY = "diffuseColor='0.7 0.7 0.7'";
  private static final String LAMP = "<PointLight DEF='Lamp' location='2 3 2'/>";

  private static final LightStorageSettings COARSE =
      new LightStorageSettings(LightStorageSettings.Kind.TEXTURES, OptionalDouble.of(8), 4, true);

  private static final RadiositySettings QUICK = quick(COARSE);

  @TempDir private Path folder;
  private final ProblemCollector problems = new ProblemCollector();
  private Path scenes;

  private static RadiositySettings quick(LightStorageSettings store) {
    return new RadiositySettings(
        50,
        95,
        OptionalDouble.empty(),
        OptionalDouble.of(0.7),
        true,
        true,
        true,
        16,
        1,
        0,
        300_000,
        store);
  }

  @BeforeEach
  void makeFolders() throws IOException {
    scenes = Files.createDirectories(folder.resolve("scenes"));
    Files.createDirectories(folder.resolve("inlineNodes"));
  }

  private RadiosityJob job(String body, RadiositySettings settings) throws IOException {
    Path scene = Files.writeString(scenes.resolve("room.x3d"), TestScenes.x3d(body));
    Path output = RadiosityJob.outputOf(scene);
    return new RadiosityJob(scene, output, RadiosityJob.inlinesOf(output), null, settings);
  }

  private RadiosityJob.Report light(String body, RadiositySettings settings)
      throws IOException, RadiosityException {
    return job(body, settings).run(problems, RadiosityProgress.NONE, (balance, quality) -> {});
  }

  private InstanceTree lit() throws IOException {
    return lit(scenes.resolve("room-lit.x3d"));
  }

  private InstanceTree lit(Path file) throws IOException {
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      LoadedScene loaded = loader.load(file);
      return new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets());
    }
  }

  private String litText() throws IOException {
    return Files.readString(scenes.resolve("room-lit.x3d"));
  }

  private Map<String, String> written() throws IOException {
    Map<String, String> contents = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        contents.put(
            folder.relativize(file).toString().replace('\\', '/'),
            Base64.getEncoder().encodeToString(Files.readAllBytes(file)));
      }
    }
    return contents;
  }

  /** The light's picture on a shape. */
  private static Texture.Image picture(ShapeInstance shape) {
    Texture texture = shape.surface().texture();
    assertThat(texture).isNotNull();
    assertThat(texture.repeatS()).isFalse();
    assertThat(texture.repeatT()).isFalse();
    return texture.image();
  }

  /** The display colour at a place of a shape, by its texture coordinates. */
  private static int[] shown(ShapeInstance shape, double x, double y, double z) {
    float[] points = shape.mesh().orElseThrow().positions();
    float[] st = shape.mesh().orElseThrow().texCoords();
    int best = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < points.length / 3; i++) {
      double distance =
          Math.hypot(Math.hypot(points[3 * i] - x, points[3 * i + 1] - y), points[3 * i + 2] - z);
      if (distance < least) {
        least = distance;
        best = i;
      }
    }
    Texture.Image image = picture(shape);
    int column = (int) Math.min(image.width() - 1, st[2 * best] * image.width());
    int row = (int) Math.min(image.height() - 1, st[2 * best + 1] * image.height());
    int at = 4 * (row * image.width() + column);
    return new int[] {
      image.rgba()[at] & 0xff, image.rgba()[at + 1] & 0xff, image.rgba()[at + 2] & 0xff
    };
  }

  @Test
  void aLitSceneShowsPicturesWithoutLamps() throws Exception {
    RadiosityJob.Report report = light(room(0, 0, 0, 4, GREY) + LAMP, QUICK);
    assertThat(problems.list()).isEmpty();
    assertThat(written().keySet())
        .containsExactly("scenes/room-lit-light.png", "scenes/room-lit.x3d", "scenes/room.x3d");
    ShapeInstance shape = lit().shapes().get(0);
    assertThat(problems.list()).isEmpty();
    assertThat(shape.surface().lit()).isFalse();
    assertThat(shape.mesh().orElseThrow().polygons()).isEqualTo(12);
    int[] ceiling = shown(shape, 0, 4, 0);
    int[] floor = shown(shape, 0, 0, 0);
    assertThat(ceiling[0]).isBetween(20, 250);
    assertThat(floor[0]).isBetween(20, 250).isLessThan(ceiling[0] + 60);
    assertThat(litText()).contains("on='false'", "version='3.3'").doesNotContain("Material");
    assertThat(report.vertices()).isZero();
    LightmapReport pictures = report.pictures();
    assertThat(pictures).isNotNull();
    assertThat(pictures.files()).isEqualTo(1);
    assertThat(pictures.bytes()).isEqualTo(Files.size(scenes.resolve("room-lit-light.png")));
    assertThat(pictures.leastPerMetre()).isBetween(7.0, 50.0);
  }

  @Test
  void thePreviewShowsLightAtTexelsBeforeAllOfItIsGathered() throws Exception {
    RadiosityJob job =
        job("<Viewpoint position='2 2 3.9'/>" + room(0, 0, 0, 4, GREY) + LAMP, QUICK);
    Path preview = folder.resolve("p.png");
    List<byte[]> shown = Collections.synchronizedList(new ArrayList<>());
    RadiosityProgress watching =
        new RadiosityProgress() {
          @Override
          public void at(Stage stage, double share) {
            if (stage == Stage.TEXELS) {
              try {
                shown.add(Files.readAllBytes(preview));
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            }
          }

          @Override
          public boolean cancelled() {
            return false;
          }
        };
    new RadiosityJob(job.scene(), job.output(), job.inlines(), preview, QUICK)
        .run(problems, watching, (balance, quality) -> {});
    assertThat(shown.get(0)).as("by patches").isNotEqualTo(shown.get(shown.size() - 1));
    assertThat(Files.readAllBytes(preview))
        .as("with all light")
        .isNotEqualTo(shown.get(shown.size() - 1));
  }

  @Test
  void eachFileHasItsOwnPictures() throws Exception {
    Files.writeString(
        folder.resolve("inlineNodes/cup.x3d"),
        TestScenes.x3d(
            "<Shape><Appearance><Material/></Appearance><Box size='.3 .3 .3'/></Shape>"));
    String cup =
        "<Transform translation='%s'><Inline url='\"../inlineNodes/cup.x3d\"'/></Transform>";
    light(room(0, 0, 0, 4, GREY) + LAMP + cup.formatted("1 1 1") + cup.formatted("3 1 3"), QUICK);
    assertThat(written().keySet())
        .contains(
            "inlineNodes/room-lit/cup-light.png",
            "inlineNodes/room-lit/cup-2-light.png",
            "scenes/room-lit-light.png");
    for (ShapeInstance shape : lit().shapes()) {
      picture(shape);
    }
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void filesWhoseNamesWouldMeetHaveOneEach() throws Exception {
    String cup =
        TestScenes.x3d("<Shape><Appearance><Material/></Appearance><Box size='.3 .3 .3'/></Shape>");
    StringBuilder inlines = new StringBuilder();
    for (String name : List.of("cup", "cup-2", "Cup", "cup")) {
      Files.writeString(folder.resolve("inlineNodes/" + name + ".x3d"), cup);
      inlines.append("<Inline url='\"../inlineNodes/" + name + ".x3d\"'/>");
    }
    light(room(0, 0, 0, 4, GREY) + LAMP + inlines, QUICK);
    List<String> names =
        written().keySet().stream()
            .filter(name -> name.startsWith("inlineNodes/room-lit/") && name.endsWith(".x3d"))
            .map(name -> name.toLowerCase(Locale.ROOT))
            .distinct()
            .toList();
    assertThat(names).hasSize(4);
    assertThat(lit().shapes()).hasSize(5);
    assertThat(problems.list()).isEmpty();
  }

  /** Signs that mean something else in a url. */
  @Test
  void aNameOfAnyLettersLeadsToItsPictures() throws Exception {
    Path scene =
        Files.writeString(
            scenes.resolve("my room #1%41.x3d"), TestScenes.x3d(room(0, 0, 0, 4, GREY) + LAMP));
    Path output = RadiosityJob.outputOf(scene);
    new RadiosityJob(scene, output, RadiosityJob.inlinesOf(output), null, QUICK)
        .run(problems, RadiosityProgress.NONE, (balance, quality) -> {});
    assertThat(written().keySet()).contains("scenes/my room #1%41-lit-light.png");
    picture(lit(output).shapes().get(0));
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void theNumberOfPolygonsAskedForIsKeptAndLightGoesOnOverThem() throws Exception {
    String budget =
        "<MetadataSet containerField='metadata' name='radiosity'>"
            + "<MetadataInteger containerField='value' name='polygons' value='334'/></MetadataSet>";
    light("<Group>" + budget + room(0, 0, 0, 4, GREY) + "</Group>" + LAMP, QUICK);
    ShapeInstance shape = lit().shapes().get(0);
    assertThat(shape.mesh().orElseThrow().polygons()).isEqualTo(334);
    // What is divided shows the same texel at a corner as what is not.
    int[] divided = shown(shape, 0, 4, 0);
    light(room(0, 0, 0, 4, GREY) + LAMP, QUICK);
    assertThat(shown(lit().shapes().get(0), 0, 4, 0)).isEqualTo(divided);
  }

  @Test
  void theSameBytesOnOneProcessorAndOnFour() throws Exception {
    String body =
        room(0, 0, 0, 4, GREY)
            + quad("1 1 1, 1 1 3, 3 1 3, 3 1 1", GREY + " specularColor='1 1 1'")
            + LAMP;
    List<Map<String, String>> results = new ArrayList<>();
    for (int processors : new int[] {1, 4}) {
      ForkJoinPool pool = new ForkJoinPool(processors);
      try {
        pool.submit(() -> light(body, QUICK)).get();
      } finally {
        pool.shutdown();
      }
      results.add(written());
    }
    assertThat(results.get(0)).isEqualTo(results.get(1));
  }

  @Test
  void whatShinesKeepsItsHighlightsAndTheLampsStayOn() throws Exception {
    String ball =
        quad("1 1 1, 1 1 3, 3 1 3, 3 1 1", "diffuseColor='.5 .1 .1' specularColor='.8 .8 .8'");
    light(room(0, 0, 0, 4, GREY) + ball + LAMP, QUICK);
    InstanceTree tree = lit();
    SurfaceMaterial shining = tree.shapes().get(1).surface();
    assertThat(shining.lit()).isTrue();
    assertThat(shining.diffuse()).containsExactly(0, 0, 0);
    assertThat(shining.specular()).containsExactly(0.8f, 0.8f, 0.8f);
    assertThat(shining.emissive()).containsExactly(1, 1, 1);
    assertThat(tree.shapes().get(1).mesh().orElseThrow().normals()).isNotNull();
    LightInstance lamp = tree.lights().get(0);
    assertThat(lamp.light().on()).isTrue();
    assertThat(lamp.light().intensity()).isBetween(0.3f, 1f);
    assertThat(lamp.light().attenuation()).containsExactly(0, 0.5f, 0);
    assertThat(litText()).contains("version='4.0'", "containerField='emissiveTexture'");
    assertThat(tree.shapes().get(0).surface().lit()).isFalse();
    assertThat(problems.list()).isEmpty();

    light(
        room(0, 0, 0, 4, GREY) + ball + LAMP,
        quick(
            new LightStorageSettings(
                LightStorageSettings.Kind.TEXTURES, OptionalDouble.of(8), 4, false)));
    assertThat(litText()).contains("version='3.3'", "on='false'").doesNotContain("Material");
  }

  /**
   * Facets a hundred thousandth as high as the shape is wide: rounded more they would have none.
   */
  @Test
  void thinFacetsKeepTheirAreaInTheText() throws Exception {
    String thin =
        "<Switch whichChoice='0'>"
            + quad("1 1 1, 1 1 2, 1.00001 1 2, 1.00001 1 1", GREY)
            + "</Switch>";
    light(room(0, 0, 0, 4, GREY) + LAMP + thin, QUICK);
    assertThat(lit().shapes().get(1).mesh().orElseThrow().polygons()).isEqualTo(2);
  }

  @Test
  void whatIsTransparentStaysSo() throws Exception {
    light(
        room(0, 0, 0, 4, GREY)
            + quad("1 1 1, 1 1 3, 3 1 3, 3 1 1", GREY + " transparency='0.4'")
            + LAMP,
        QUICK);
    SurfaceMaterial glass = lit().shapes().get(1).surface();
    assertThat(glass.lit()).isFalse();
    assertThat(glass.transparency()).isEqualTo(0.4f);
    assertThat(litText()).contains("<UnlitMaterial transparency='0.4'");
  }

  /** A floor with an image that is repeated often, of two shades of one colour. */
  private static String tiled(String image) {
    return "<Shape><Appearance><Material/>"
        + "<ImageTexture url='\""
        + image
        + "\"'/><TextureTransform scale='40 40'/></Appearance>"
        + "<IndexedFaceSet coordIndex='0 1 2 3 -1' texCoordIndex='0 1 2 3 -1'>"
        + "<Coordinate point='0 .1 0, 0 .1 4, 4 .1 4, 4 .1 0'/>"
        + "<TextureCoordinate point='0 0, 0 1, 1 1, 1 0'/></IndexedFaceSet></Shape>";
  }

  @Test
  void aTiledTextureIsMultipliedByItsLight() throws Exception {
    byte[] stripes = new byte[3 * 16];
    for (int i = 0; i < stripes.length; i++) {
      stripes[i] = (byte) (i / 3 % 2 == 0 ? 100 : 180);
    }
    Files.write(scenes.resolve("stripes.png"), PngEncoder.of(16, 1, stripes));
    Path own = Files.writeString(scenes.resolve("stripes-bright.png"), "the author's");
    RadiosityJob.Report report = light(room(0, 0, 0, 4, GREY) + LAMP + tiled("stripes.png"), QUICK);
    assertThat(report.pictures().multiplied()).isEqualTo(1);
    assertThat(litText())
        .contains(
            "<MultiTexture mode='\"MODULATE\" \"MODULATE\"'", "url='\"room-lit-stripes-bright.png")
        .contains("<MultiTextureCoordinate")
        .doesNotContain("TextureTransform");
    assertThat(own).hasContent("the author's");
    ShapeInstance floor = lit().shapes().get(1);
    assertThat(floor.mesh().orElseThrow().texCoords()).contains(40f);
    assertThat(problems.list()).isEmpty();

    // At the mean of the texture the product is the colour that a plain floor of that mean has.
    double mean = (Photometry.linear(100 / 255.0) + Photometry.linear(180 / 255.0)) / 2;
    double display = Photometry.display(mean);
    double factor = litText().contains("room-lit-stripes-bright.png") ? 255.0 / 180 : 1;
    int[] product = light(floor, 1);
    String plain = "diffuseColor='%1$s %1$s %1$s'".formatted(display);
    light(room(0, 0, 0, 4, GREY) + LAMP + quad("0 .1 0, 0 .1 4, 4 .1 4, 4 .1 0", plain), QUICK);
    int[] expected = shown(lit().shapes().get(1), 4, .1, 4);
    assertThat(product[0] * factor * display).isCloseTo(expected[0], offset(4.0));
  }

  @Test
  void brighterImagesWhoseNamesDifferByCapitalsHaveAFileEach() throws Exception {
    byte[] dark = new byte[3 * 16];
    Arrays.fill(dark, (byte) 60);
    for (String name : List.of("a/Wood.png", "b/wood.png")) {
      Path file = scenes.resolve(name);
      Files.createDirectories(file.getParent());
      Files.write(file, PngEncoder.of(16, 1, dark));
    }
    String left = tiled("a/Wood.png").replace("4 .1 4, 4 .1 0", "2 .1 4, 2 .1 0");
    String right = tiled("b/wood.png").replace("0 .1 0, 0 .1 4", "2 .1 0, 2 .1 4");
    light(room(0, 0, 0, 4, GREY) + LAMP + left + right, QUICK);
    assertThat(written().keySet())
        .filteredOn(name -> name.toLowerCase(Locale.ROOT).contains("wood-bright"))
        .hasSize(2)
        .extracting(name -> name.toLowerCase(Locale.ROOT))
        .doesNotHaveDuplicates();
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aBrighterImageKeepsWhatItsNodeSaysAndLeavesTheNameToTheImageItself() throws Exception {
    byte[] dark = new byte[3 * 16];
    Arrays.fill(dark, (byte) 60);
    Files.write(scenes.resolve("wood.png"), PngEncoder.of(16, 1, dark));
    String says =
        "' repeatT='false' DEF='Wood'>"
            + "<TextureProperties DEF='Sharp' anisotropicDegree='8' magnificationFilter='NICEST'/>"
            + "<MetadataString DEF='Source' name='source' value='\"oak\"'/></ImageTexture>";
    String shaded = tiled("wood.png").replaceFirst("'/><Tex", says + "<Tex");
    String again = shaded.replaceFirst("<ImageT.*</ImageTexture>", "<ImageTexture USE='Wood'/>");
    String byItself =
        "<Shape><Appearance><UnlitMaterial/><ImageTexture USE='Wood'/></Appearance>"
            + "<Box size='.1 .1 .1'/></Shape>";
    light(room(0, 0, 0, 4, GREY) + LAMP + shaded + again + byItself, QUICK);
    assertThat(problems.list()).isEmpty();
    assertThat(litText())
        .contains("url='\"room-lit-wood-bright.png\"' repeatT='false'>")
        .contains("<TextureProperties DEF='Sharp' anisotropicDegree='8'")
        .contains("<MetadataString DEF='Source'", "name='source' value='\"oak\"'")
        .contains("<ImageTexture DEF='Wood'", "url='\"wood.png\"'");
    Texture.Image bright =
        ((Texture) lit().shapes().get(1).surface().detail().units().get(0).source()).image();
    assertThat(bright.rgba()[0] & 0xff).isEqualTo(240);
    assertThat(lit().shapes().get(3).surface().texture().image().rgba()[0] & 0xff).isEqualTo(60);
  }

  /** The picture of light of a shape with an image of its own, where x and z are largest. */
  private static int[] light(ShapeInstance shape, int unit) {
    var detail = shape.surface().detail();
    assertThat(detail).isNotNull();
    Texture.Image image = ((Texture) detail.units().get(unit).source()).image();
    float[] points = shape.mesh().orElseThrow().positions();
    float[] st = shape.mesh().orElseThrow().moreTexCoords().get(0).values();
    int best = 0;
    for (int i = 1; i < points.length / 3; i++) {
      boolean farther = points[3 * i] + points[3 * i + 2] > points[3 * best] + points[3 * best + 2];
      best = farther ? i : best;
    }
    int column = (int) Math.min(image.width() - 1, st[2 * best] * image.width());
    int row = (int) Math.min(image.height() - 1, st[2 * best + 1] * image.height());
    int at = 4 * (row * image.width() + column);
    return new int[] {image.rgba()[at] & 0xff, image.rgba()[at + 1] & 0xff};
  }

  @Test
  void imagesOfAMultiTextureBeyondTheFirstAreSaidToBeMissing() throws Exception {
    String two =
        "<Shape><Appearance><Material/><MultiTexture>"
            + "<PixelTexture image='1 1 3 0xff0000'/><PixelTexture image='1 1 3 0x00ff00'/>"
            + "</MultiTexture></Appearance><Box size='.2 .2 .2'/></Shape>";
    light(room(0, 0, 0, 4, GREY) + LAMP + two, QUICK);
    assertThat(problems.list().stream().map(Problem::toString))
        .anySatisfy(
            line ->
                assertThat(line)
                    .contains("room.x3d:")
                    .endsWith(
                        "the lit scene has the first of the 2 images of this MultiTexture only;"
                            + " make one image of them to keep what the others show (1 shape)"));
  }

  @Test
  void whatAScaleOfNothingFlattensStaysAsItIsAndCastsNoShadow() throws Exception {
    String flat =
        "<Transform translation='2 1 2' scale='1 0 1'><Shape DEF='Flat'><Appearance>"
            + "<Material diffuseColor='0 1 0'/></Appearance><Box size='3 3 3'/></Shape></Transform>";
    light(room(0, 0, 0, 4, GREY) + LAMP, QUICK);
    Path picture = scenes.resolve("room-lit-light.png");
    byte[] without = Files.readAllBytes(picture);
    light(room(0, 0, 0, 4, GREY) + LAMP + flat, QUICK);
    assertThat(litText()).contains("<Box size='3 3 3'/>").contains("diffuseColor='0 1 0'");
    assertThat(Files.readAllBytes(picture)).isEqualTo(without);
  }

  @Test
  void aTextureAsCoarseAsTheLightBecomesPartOfItsPicture() throws Exception {
    byte[] halves = new byte[3 * 8 * 8];
    for (int i = 0; i < halves.length; i++) {
      halves[i] = (byte) (i % 3 == 0 || i / 3 % 8 > 3 ? 220 : 20);
    }
    Files.write(scenes.resolve("halves.png"), PngEncoder.of(8, 8, halves));
    String floor =
        tiled("halves.png").replace("40 40", "1 1").replace("'/><Tex", "' repeatS='false'/><Tex");
    RadiosityJob.Report report = light(room(0, 0, 0, 4, GREY) + LAMP + floor, QUICK);
    assertThat(report.pictures().multiplied()).isZero();
    assertThat(litText()).doesNotContain("halves.png");
    ShapeInstance shape = lit().shapes().get(1);
    int[] red = shown(shape, 0, .1, 0);
    int[] white = shown(shape, 4, .1, 4);
    assertThat(red[0]).isGreaterThan(2 * red[1]);
    assertThat(white[1]).isGreaterThan(white[0] * 3 / 4);
  }

  /** A floor of 4 m with an image of 64 pixels, two for each texel that its light has by itself. */
  @Test
  void whatShinesHasItsImageInThePictureOfItsLight() throws Exception {
    byte[] halves = new byte[3 * 64 * 64];
    for (int i = 0; i < halves.length; i++) {
      halves[i] = (byte) (i % 3 == 0 || i / 3 % 64 > 31 ? 220 : 20);
    }
    Files.write(scenes.resolve("halves.png"), PngEncoder.of(64, 64, halves));
    String matt = tiled("halves.png").replace("40 40", "1 1");
    RadiosityJob.Report before = light(room(0, 0, 0, 4, GREY) + LAMP + matt, QUICK);
    assertThat(before.pictures().multiplied()).isEqualTo(1);

    String shiny = matt.replace("<Material", "<Material specularColor='.8 .8 .8' shininess='.5'");
    RadiosityJob.Report report = light(room(0, 0, 0, 4, GREY) + LAMP + shiny, QUICK);
    assertThat(problems.list()).isEmpty();
    assertThat(report.pictures().multiplied()).isZero();
    assertThat(report.pictures().shining()).isEqualTo(1);
    ShapeInstance floor = lit().shapes().get(1);
    assertThat(floor.surface().specular()).containsExactly(0.8f, 0.8f, 0.8f);
    assertThat(litText()).contains("containerField='emissiveTexture'").doesNotContain("halves.png");
    assertThat(lit().lights().get(0).light().on()).isTrue();
    BufferedImage picture = ImageIO.read(scenes.resolve("room-lit-light.png").toFile());
    int reds = 0;
    int whites = 0;
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        int red = picture.getRGB(x, y) >> 16 & 0xff;
        int green = picture.getRGB(x, y) >> 8 & 0xff;
        reds += red > 30 && red > 3 * green ? 1 : 0;
        whites += red > 30 && green > red * 3 / 4 ? 1 : 0;
      }
    }
    assertThat(reds).isGreaterThan(64 * 64 / 4);
    assertThat(whites).isGreaterThan(64 * 64 / 4);
  }

  @Test
  void whatShinesWithAnImageMuchFinerThanItsLightStaysMattAndIsSaid() throws Exception {
    Files.write(scenes.resolve("tiles.png"), PngEncoder.of(64, 64, new byte[3 * 64 * 64]));
    String shiny = tiled("tiles.png").replace("<Material", "<Material specularColor='.8 .8 .8'");
    RadiosityJob.Report report = light(room(0, 0, 0, 4, GREY) + LAMP + shiny, QUICK);
    assertThat(report.pictures().multiplied()).isEqualTo(1);
    assertThat(litText()).contains("<MultiTexture", "on='false'");
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).toString())
        .contains("room.x3d:")
        .contains("the surface loses its highlights")
        .endsWith("(1 shape)");
  }

  @Test
  void aTextureThatCannotBeReadLeavesThePlainColour() throws Exception {
    light(room(0, 0, 0, 4, GREY) + LAMP + tiled("absent.png"), QUICK);
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).toString()).contains("absent.png");
    assertThat(litText()).doesNotContain("absent.png").doesNotContain("MultiTexture");
  }

  @Test
  void coordinatesWithoutExtentAreSaidOnce() throws Exception {
    Files.write(scenes.resolve("dot.png"), PngEncoder.of(1, 1, new byte[] {50, 60, 70}));
    String flat = tiled("dot.png").replace("0 0, 0 1, 1 1, 1 0", "0 0, 0 0, 0 0, 0 0");
    light(room(0, 0, 0, 4, GREY) + LAMP + flat + flat, QUICK);
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).message()).contains("on one line or point", "2 shapes");
  }

  @Test
  void aBudgetThatCannotBeKeptIsSaidBeforeTheWork() throws Exception {
    LightStorageSettings small =
        new LightStorageSettings(
            LightStorageSettings.Kind.TEXTURES, OptionalDouble.of(500), 0.05, true);
    int[] iterations = {0};
    assertThatThrownBy(
            () ->
                job(room(0, 0, 0, 4, GREY) + LAMP, quick(small))
                    .run(problems, RadiosityProgress.NONE, (b, q) -> iterations[0]++))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("--texture-budget");
    assertThat(iterations[0]).isZero();
    assertThat(written().keySet()).containsExactly("scenes/room.x3d");
  }

  @Test
  void aCancelledRunWritesItsLastIterationWithPictures() throws Exception {
    int[] iterations = {0};
    RadiosityProgress cancelling =
        new RadiosityProgress() {
          @Override
          public void at(Stage stage, double share) {
            // Only its end matters.
          }

          @Override
          public boolean cancelled() {
            return iterations[0] >= 2;
          }
        };
    RadiosityJob.Report report =
        job(room(0, 0, 0, 4, GREY) + LAMP, QUICK)
            .run(problems, cancelling, (balance, quality) -> iterations[0]++);
    assertThat(report.complete()).isFalse();
    assertThat(shown(lit().shapes().get(0), 0, 4, 0)[0]).isGreaterThan(10);
  }

  @Test
  void whereAFileCannotBeWrittenThereIsNone() throws Exception {
    Files.createDirectories(scenes.resolve("room-lit-light.png"));
    assertThatThrownBy(() -> light(room(0, 0, 0, 4, GREY) + LAMP, QUICK))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("room-lit-light.png");
    assertThat(written().keySet()).containsExactly("scenes/room.x3d");
  }

  @Test
  void aPictureThatShinesByItselfStaysAsItIs() throws Exception {
    Files.write(scenes.resolve("view.png"), PngEncoder.of(1, 1, new byte[] {50, 60, 70}));
    String view = tiled("view.png").replace("<Material/>", "<UnlitMaterial/>");
    light(room(0, 0, 0, 4, GREY) + LAMP + view, QUICK);
    assertThat(litText()).contains("view.png", "<UnlitMaterial", "TextureTransform");
  }
}
