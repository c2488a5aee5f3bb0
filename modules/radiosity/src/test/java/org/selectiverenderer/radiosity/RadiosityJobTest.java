package org.selectiverenderer.radiosity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.selectiverenderer.radiosity.TestScenes.quad;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Scene files to lit scene files. */
class RadiosityJobTest {
  private static final String GREY = "diffuseColor='0.7 0.7 0.7'";
  private static final String LAMP = "<PointLight DEF='Lamp' location='2 3 2'/>";
  private static final String BUDGET =
      "<MetadataSet containerField='metadata' name='radiosity'>"
          + "<MetadataInteger containerField='value' name='polygons' value='%d'/></MetadataSet>";

  private static final RadiositySettings QUICK =
      new RadiositySettings(
          50,
          98,
          OptionalDouble.empty(),
          OptionalDouble.of(0.7),
          true,
          true,
          true,
          16,
          1,
          0,
          300_000,
          LightStorageSettings.VERTICES);

  @TempDir private Path folder;
  private final ProblemCollector problems = new ProblemCollector();
  private Path scenes;

  @BeforeEach
  void makeFolders() throws IOException {
    scenes = Files.createDirectories(folder.resolve("scenes"));
    Files.createDirectories(folder.resolve("inlineNodes"));
  }

  private Path scene(String body) throws IOException {
    Path file = scenes.resolve("room.x3d");
    Files.writeString(file, TestScenes.x3d(body));
    return file;
  }

  private void inlined(String name, String body) throws IOException {
    Files.writeString(folder.resolve("inlineNodes").resolve(name), TestScenes.x3d(body));
  }

  private RadiosityJob job(Path scene, RadiositySettings settings) {
    Path output = RadiosityJob.outputOf(scene);
    return new RadiosityJob(scene, output, RadiosityJob.inlinesOf(output), null, settings);
  }

  private RadiosityJob.Report light(String body) throws IOException, RadiosityException {
    return job(scene(body), QUICK).run(problems, RadiosityProgress.NONE, (balance, quality) -> {});
  }

  /** Every shape of the lit scene: its colours, unlit. */
  private List<ShapeInstance> shapes() throws IOException {
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      LoadedScene loaded = loader.load(scenes.resolve("room-lit.x3d"));
      return new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets()).shapes();
    }
  }

  private Map<String, String> written() throws IOException {
    Map<String, String> texts = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        texts.put(
            folder.relativize(file).toString().replace('\\', '/'),
            Files.readString(file, StandardCharsets.ISO_8859_1));
      }
    }
    return texts;
  }

  @Test
  void aLitSceneShowsItsColoursWithoutLamps() throws Exception {
    Path scene = scene(room(0, 0, 0, 4, GREY) + LAMP);
    String before = Files.readString(scene);
    job(scene, QUICK).run(problems, RadiosityProgress.NONE, (balance, quality) -> {});
    assertThat(Files.readString(scene)).isEqualTo(before);
    assertThat(problems.list()).isEmpty();
    ShapeInstance shape = shapes().get(0);
    assertThat(shape.surface().lit()).isFalse();
    float[] colours = shape.mesh().orElseThrow().colors();
    assertThat(colours).isNotNull();
    for (float colour : colours) {
      assertThat(colour).isBetween(0.02f, 1f);
    }
    assertThat(Files.readString(scenes.resolve("room-lit.x3d")))
        .contains("DEF='Lamp'")
        .contains("on='false'");
  }

  @Test
  void aFileThatTheSceneIsMadeOfIsNotWrittenOver() throws Exception {
    inlined("walls.x3d", room(0, 0, 0, 4, GREY));
    Path scene = scene("<Inline url='\"../inlineNodes/walls.x3d\"'/>" + LAMP);
    Path inlines = folder.resolve("inlineNodes");
    Map<String, String> before = written();
    for (RadiosityJob job :
        List.of(
            new RadiosityJob(scene, scenes.resolve("lit.x3d"), inlines, null, QUICK),
            new RadiosityJob(
                scene, inlines.resolve("walls.x3d"), folder.resolve("lit"), null, QUICK))) {
      assertThatThrownBy(() -> job.run(problems, RadiosityProgress.NONE, (balance, quality) -> {}))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("walls.x3d: the scene is made of this file");
    }
    assertThat(written()).isEqualTo(before);
  }

  @Test
  void aPictureThatTheSceneShowsIsNotWrittenOver() throws Exception {
    Path picture = Files.write(scenes.resolve("wood.png"), PngEncoder.of(1, 1, new byte[3]));
    Path light = Files.copy(picture, scenes.resolve("room-lit-light.png"));
    Path brighter = Files.copy(picture, folder.resolve("inlineNodes/Walls-2-tiles-bright.png"));
    String shows =
        "<Shape><Appearance><Material/><ImageTexture url='\"%s\"'/></Appearance><Box/></Shape>";
    Path parts = Files.createDirectories(scenes.resolve("parts"));
    Files.writeString(parts.resolve("walls.x3d"), TestScenes.x3d(room(0, 0, 0, 4, GREY)));
    Path inlines = folder.resolve("inlineNodes");
    for (Path shown : List.of(picture, light, brighter)) {
      Path scene =
          scene(
              "<Inline url='\"parts/walls.x3d\"'/>"
                  + LAMP
                  + shows.formatted(scenes.relativize(shown)));
      Map<String, String> before = written();
      RadiosityJob job =
          new RadiosityJob(
              scene,
              scenes.resolve("room-lit.x3d"),
              inlines,
              shown.equals(picture) ? scenes.resolve("../scenes/wood.png") : null,
              QUICK);
      assertThatThrownBy(() -> job.run(problems, RadiosityProgress.NONE, (balance, quality) -> {}))
          .isInstanceOf(IOException.class)
          .hasMessageContaining(shown.getFileName() + ": the scene is made of this file");
      assertThat(written()).isEqualTo(before);
    }
  }

  @Test
  void aBudgetIsKeptToThePolygon() throws Exception {
    inlined("walls.x3d", room(0, 0, 0, 4, GREY));
    light(
        "<Inline url='\"../inlineNodes/walls.x3d\"'>"
            + BUDGET.formatted(334)
            + "</Inline>"
            + quad("1 1 1, 1 1 3, 3 1 3, 3 1 1", GREY)
            + LAMP);
    assertThat(shapes().get(0).mesh().orElseThrow().polygons()).isEqualTo(334);
    assertThat(shapes().get(1).mesh().orElseThrow().polygons()).isEqualTo(2);
  }

  @Test
  void facetsAreFinerInTheShadowOfATable() throws Exception {
    light(
        "<Group>"
            + BUDGET.formatted(600)
            + quad("0 0 0, 0 0 8, 8 0 8, 8 0 0", GREY)
            + "</Group>"
            + quad("1 0.5 1, 1 0.5 2.5, 2.5 0.5 2.5, 2.5 0.5 1", GREY + " ")
            + LAMP);
    float[] points = shapes().get(0).mesh().orElseThrow().positions();
    int near = 0;
    int far = 0;
    for (int i = 0; i < points.length; i += 3) {
      near += points[i] < 4 && points[i + 2] < 4 ? 1 : 0;
      far += points[i] > 4 && points[i + 2] > 4 ? 1 : 0;
    }
    assertThat(near).isGreaterThan(3 * far);
  }

  @Test
  void versionsKeepTheirPolygonsAndAreLitInEachPlace() throws Exception {
    inlined(
        "fine.x3d", "<Shape><Appearance><Material/></Appearance><Sphere radius='0.3'/></Shape>");
    inlined(
        "coarse.x3d", "<Shape><Appearance><Material/></Appearance><Box size='.5 .5 .5'/></Shape>");
    String versions =
        "<Switch DEF='%s' whichChoice='1'><Inline url='\"../inlineNodes/fine.x3d\"'/>"
            + "<Inline url='\"../inlineNodes/coarse.x3d\"'/></Switch>";
    light(
        room(0, 0, 0, 4, GREY)
            + LAMP
            + "<Transform translation='1 .5 1'>"
            + versions.formatted("A")
            + "</Transform><Transform translation='3 3.6 3'>"
            + versions.formatted("B")
            + "</Transform>");
    assertThat(problems.list()).isEmpty();
    List<ShapeInstance> shapes = shapes();
    assertThat(shapes).hasSize(5);
    double[] means = new double[5];
    for (int i = 0; i < 5; i++) {
      float[] colours = shapes.get(i).mesh().orElseThrow().colors();
      for (int k = 0; k < colours.length; k += 4) {
        means[i] += 4.0 * colours[k] / colours.length;
      }
    }
    assertThat(shapes.get(2).mesh().orElseThrow().polygons()).isEqualTo(12);
    assertThat(means[1]).isNotEqualTo(means[3]);
    // A version does not shadow the other one in its place.
    assertThat(means[2] / means[1]).isBetween(0.75, 1.25);
    assertThat(means[4] / means[3]).isBetween(0.75, 1.25);
    assertThat(written().keySet())
        .contains(
            "inlineNodes/room-lit/fine.x3d",
            "inlineNodes/room-lit/fine-2.x3d",
            "inlineNodes/room-lit/coarse.x3d",
            "inlineNodes/room-lit/coarse-2.x3d");
  }

  @Test
  void theSameSeedGivesTheSameBytesOnOneProcessorAndOnFour() throws Exception {
    String body = room(0, 0, 0, 4, GREY) + quad("1 1 1, 1 1 3, 3 1 3, 3 1 1", GREY) + LAMP;
    List<Map<String, String>> results = new ArrayList<>();
    for (int processors : new int[] {1, 4}) {
      ForkJoinPool pool = new ForkJoinPool(processors);
      try {
        pool.submit(
                () -> {
                  light(body);
                  return null;
                })
            .get();
      } finally {
        pool.shutdown();
      }
      results.add(written());
    }
    assertThat(results.get(0)).isEqualTo(results.get(1));
  }

  @Test
  void aCancelledRunWritesItsLastIteration() throws Exception {
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
        job(scene(room(0, 0, 0, 4, GREY) + LAMP), QUICK)
            .run(problems, cancelling, (balance, quality) -> iterations[0]++);
    assertThat(report.complete()).isFalse();
    assertThat(report.balance().iteration()).isEqualTo(2);
    for (float colour : shapes().get(0).mesh().orElseThrow().colors()) {
      assertThat(colour).isGreaterThan(0.02f);
    }
  }

  @Test
  void whatIsCancelledBeforeTheFirstIterationIsNotWritten() throws Exception {
    RadiosityProgress cancelling = new CancelAtStage(RadiosityProgress.Stage.TRANSPORT);
    Path scene = scene(room(0, 0, 0, 4, GREY) + LAMP);
    assertThatThrownBy(() -> job(scene, QUICK).run(problems, cancelling, (b, q) -> {}))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("cancelled before the first iteration");
    assertThat(written().keySet()).containsExactly("scenes/room.x3d");
  }

  @Test
  void whatIsNoSceneIsSaidOnce() throws Exception {
    Path text = scenes.resolve("room.x3d");
    for (String content : List.of("hello, no XML", "", "<X3D><Scene>", "<html/>")) {
      Files.writeString(text, content);
      ProblemCollector said = new ProblemCollector();
      assertThatThrownBy(() -> job(text, QUICK).run(said, RadiosityProgress.NONE, (b, q) -> {}))
          .isInstanceOfSatisfying(
              RadiosityException.class, unlit -> assertThat(unlit.isTold()).isTrue());
      assertThat(said.list()).hasSize(1);
    }
  }

  @Test
  void ofBytesThatAreNoTextNothingIsSaidAboutTheirEncoding() throws Exception {
    Path file = scenes.resolve("room.x3d");
    Files.write(file, new byte[] {'x', (byte) 0xff, (byte) 0xfe, 0x12, (byte) 0x80});
    assertThatThrownBy(() -> job(file, QUICK).run(problems, RadiosityProgress.NONE, (b, q) -> {}))
        .isInstanceOf(RadiosityException.class);
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).message()).contains("neither XML nor VRML");
  }

  @Test
  void previewIsWrittenIntoTheFileThatAViewerHasOpen() throws Exception {
    Path preview = Files.writeString(folder.resolve("p.png"), "old");
    Path scene = scene(room(0, 0, 0, 4, GREY) + LAMP);
    try (FileChannel viewer = FileChannel.open(preview, StandardOpenOption.READ)) {
      new RadiosityJob(scene, RadiosityJob.outputOf(scene), folder, preview, QUICK)
          .run(problems, RadiosityProgress.NONE, (balance, quality) -> {});
      assertThat(viewer.size()).isEqualTo(Files.size(preview)).isGreaterThan(3);
    }
  }

  @Test
  void previewIsAPictureOfTheWholeWay() throws Exception {
    Path scene = scene("<Viewpoint position='2 2 3.9'/>" + room(0, 0, 0, 4, GREY) + LAMP);
    Path preview = folder.resolve("p.png");
    Path output = RadiosityJob.outputOf(scene);
    List<Integer> sizes = new ArrayList<>();
    new RadiosityJob(scene, output, folder, preview, QUICK)
        .run(
            problems,
            RadiosityProgress.NONE,
            (balance, quality) -> sizes.add(Files.exists(preview) ? 1 : 0));
    assertThat(Files.readAllBytes(preview)).startsWith(0x89, 'P', 'N', 'G');
    assertThat(sizes).startsWith(0, 1);
  }

  @Test
  void textsSayWhatIsWrongBeforeTheWork() throws Exception {
    String walls = room(0, 0, 0, 4, GREY);
    assertThatThrownBy(() -> light(walls))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("the scene has no light");
    assertThatThrownBy(() -> light(LAMP))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("nothing to light");
    assertThatThrownBy(() -> light(LAMP + room(0, 0, 0, 4e6, GREY)))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("100 km");
    assertThatThrownBy(() -> light(LAMP + "<Group>" + BUDGET.formatted(5) + walls + "</Group>"))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("asks for 5 polygons here");
    RadiositySettings fine =
        new RadiositySettings(
            5,
            90,
            OptionalDouble.empty(),
            OptionalDouble.of(0.001),
            true,
            true,
            true,
            16,
            1,
            0,
            300_000,
            LightStorageSettings.VERTICES);
    assertThatThrownBy(
            () ->
                job(scene(LAMP + walls), fine).run(problems, RadiosityProgress.NONE, (b, q) -> {}))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("raise --max-mesh");
    RadiositySettings immense =
        new RadiositySettings(
            5,
            90,
            OptionalDouble.empty(),
            OptionalDouble.of(0.001),
            true,
            true,
            true,
            16,
            1,
            0,
            Integer.MAX_VALUE,
            LightStorageSettings.VERTICES);
    assertThatThrownBy(
            () ->
                job(scene(LAMP + walls), immense)
                    .run(problems, RadiosityProgress.NONE, (b, q) -> {}))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("MB of memory, more than Java's");
    assertThat(written().keySet()).containsExactly("scenes/room.x3d");
  }

  @Test
  void anOpenSceneIsLitAndSaidToBeOpen() throws Exception {
    light(quad("0 0 0, 0 0 4, 4 0 4, 4 0 0", GREY) + LAMP);
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).message()).contains("the scene is open");
    assertThat(problems.any()).isFalse();
  }

  @Test
  void facesWithoutAreaAndNumbersThatAreNoneDoNoHarm() throws Exception {
    light(
        room(0, 0, 0, 4, GREY)
            + LAMP
            + "<Shape><Appearance><Material/></Appearance><IndexedFaceSet coordIndex='0 1 2 -1 0 1 1"
            + " -1 3 1 2 -1'><Coordinate point='0 1 0, 1 1 0, 2 1 0, NaN 1 1'/></IndexedFaceSet>"
            + "</Shape>");
    String text =
        new String(Files.readAllBytes(scenes.resolve("room-lit.x3d")), StandardCharsets.UTF_8);
    assertThat(text).doesNotContain("NaN");
  }
}
