package org.selectiverenderer.document.versions;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_16LE;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.files.FileActions;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.document.file.DocumentFile;
import org.selectiverenderer.polygon.model.Model;
import org.selectiverenderer.polygon.model.ModelReader;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

class VersionMakingTest {
  private static final String SCENE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "http://www.web3d.org/specifications/x3d-3.3.dtd">
      <X3D profile='Immersive'   version="3.3">
        <!-- Größe > 1 && 'quotes' -->
        <Scene>
          <Transform DEF='Table' translation='1 2 3' >
            <!-- the vase -->
            <Shape   DEF='Vase'>
              <Appearance DEF='Red'><Material diffuseColor="1 0 0"/></Appearance>
              <Sphere radius='.5'/>
            </Shape>
            <TouchSensor DEF='Touch'/>
          </Transform >
        </Scene>
      </X3D>
      """;

  private static final String CHANGED =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "http://www.web3d.org/specifications/x3d-3.3.dtd">
      <X3D profile='Immersive'   version="3.3">
        <!-- Größe > 1 && 'quotes' -->
        <Scene>
          <Transform DEF='Table' translation='1 2 3' >
            <!-- the vase -->
            <Switch DEF='Switch_Vase' whichChoice='0'>
              <Inline DEF='Inline_Vase_v1' url='"inlineNodes/Vase_v1.x3d"'/>
              <Inline DEF='Inline_Vase_v2' url='"inlineNodes/Vase_v2.x3d"'/>
              <Inline DEF='Inline_Vase_v3' url='"inlineNodes/Vase_v3.x3d"'/>
            </Switch>
            <TouchSensor DEF='Touch'/>
          </Transform >
        </Scene>
      </X3D>
      """;

  private static final List<Goal> GOALS =
      List.of(new Goal.VertexPercent(50), new Goal.VertexPercent(10));

  @TempDir Path folder;

  private final Problems problems = new Problems();
  private final NodeCatalogue catalogue = NodeCatalogue.load();

  private Path scene(byte[] bytes) throws IOException {
    return Files.write(folder.resolve("scene.x3d"), bytes);
  }

  private Path scene(String text) throws IOException {
    return scene(text.getBytes(UTF_8));
  }

  private Optional<VersionsEdit> plan(Path scene, String object, Goal... goals) throws IOException {
    return plan(new VersionsEdit.Request(scene, object, List.of(goals), "inlineNodes"));
  }

  private Optional<VersionsEdit> plan(VersionsEdit.Request request) throws IOException {
    return VersionsEdit.plan(
        DocumentFile.open(request.scene()).document().snapshot(), request, catalogue, problems);
  }

  private VersionsEdit make(Path scene, String object, Goal... goals) throws IOException {
    VersionsEdit plan = plan(scene, object, goals).orElseThrow();
    plan.write(FileActions.REAL);
    return plan;
  }

  private VersionsEdit make(Path scene, String object) throws IOException {
    return make(scene, object, GOALS.toArray(Goal[]::new));
  }

  private int polygons(String file) throws IOException {
    Optional<Model> model = new ModelReader(catalogue).read(folder.resolve(file), new Problems());
    return model.orElseThrow().polygons();
  }

  /** All files with their contents. */
  private Map<Path, String> files() throws IOException {
    Map<Path, String> contents = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        contents.put(file, Files.readString(file, ISO_8859_1));
      }
    }
    return contents;
  }

  @Test
  void aSwitchOfInlinesTakesTheObjectsPlaceAndNothingElseChanges() throws IOException {
    Path scene = scene(SCENE);

    VersionsEdit plan = make(scene, "Vase");

    assertThat(scene).hasContent(CHANGED).hasBinaryContent(CHANGED.getBytes(UTF_8));
    assertThat(plan.versions())
        .extracting(ObjectVersion::polygons)
        .startsWith(960)
        .hasSize(3)
        .isSortedAccordingTo((a, b) -> b - a);
  }

  @Test
  void theFilesHoldWhatThePlanSays() throws IOException {
    VersionsEdit plan = make(scene(SCENE), "Vase");

    for (ObjectVersion version : plan.versions()) {
      assertThat(polygons("inlineNodes/Vase_v" + version.number() + ".x3d"))
          .isEqualTo(version.polygons());
    }
    assertThat(folder.resolve("inlineNodes/Vase_v1.x3d"))
        .content()
        .contains("<Shape DEF='Vase'>", "<Sphere radius='0.5'/>", "diffuseColor='1 0 0'");
    assertThat(problems.list()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"UTF-8,\\n,false", "UTF-8,\\r\\n,true", "ISO-8859-1,\\r,false", "UTF-16,\\r\\n,true"})
  void everyEncodingAndEndOfLineIsKept(String encoding, String end, boolean mark)
      throws IOException {
    Charset charset = encoding.equals("UTF-16") ? UTF_16LE : Charset.forName(encoding);
    String lineEnd = end.replace("\\r", "\r").replace("\\n", "\n");
    byte[] before = bytes(SCENE, encoding, charset, lineEnd, mark);

    Path scene = scene(before);
    make(scene, "Vase");

    assertThat(scene).hasBinaryContent(bytes(CHANGED, encoding, charset, lineEnd, mark));
  }

  private static byte[] bytes(
      String text, String encoding, Charset charset, String lineEnd, boolean mark) {
    String changed = text.replace("UTF-8", encoding).replace("\n", lineEnd);
    return ((mark ? "\ufeff" : "") + changed).getBytes(charset);
  }

  @Test
  void aCompressedSceneStaysCompressed() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (GZIPOutputStream packed = new GZIPOutputStream(out)) {
      packed.write(SCENE.getBytes(UTF_8));
    }
    Path scene = scene(out.toByteArray());

    make(scene, "Vase");

    try (GZIPInputStream in =
        new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(scene)))) {
      assertThat(new String(in.readAllBytes(), UTF_8)).isEqualTo(CHANGED);
    }
  }

  @Test
  void theTransformRoundAnObjectStaysWithWhatIsNotDrawn() throws IOException {
    Path scene = scene(SCENE);

    make(scene, "Table");

    assertThat(scene)
        .hasContent(CHANGED.replace("Switch_Vase", "Switch_Table").replace("Vase_v", "Table_v"));
  }

  @Test
  void severalShapesBecomeOneObject() throws IOException {
    Path scene =
        scene(
            "<X3D version='3.3'><Scene>\n  <Group DEF='Set'>\n    <Shape><Box/></Shape>\n"
                + "    <Viewpoint/>\n    <Shape><Sphere/></Shape>\n  </Group>\n</Scene></X3D>\n");

    make(scene, "Set", new Goal.Polygons(100));

    assertThat(scene)
        .hasContent(
            "<X3D version='3.3'><Scene>\n  <Group DEF='Set'>\n"
                + "    <Switch DEF='Switch_Set' whichChoice='0'>\n"
                + "      <Inline DEF='Inline_Set_v1' url='\"inlineNodes/Set_v1.x3d\"'/>\n"
                + "      <Inline DEF='Inline_Set_v2' url='\"inlineNodes/Set_v2.x3d\"'/>\n"
                + "    </Switch>\n    <Viewpoint/>\n  </Group>\n</Scene></X3D>\n");
    assertThat(polygons("inlineNodes/Set_v1.x3d")).isEqualTo(972);
    assertThat(polygons("inlineNodes/Set_v2.x3d")).isBetween(98, 102);
  }

  @Test
  void anAuthorsDoubleQuotesAreTakenUp() throws IOException {
    Path scene =
        scene("<X3D version=\"3.3\"><Scene><Shape DEF=\"A\"><Sphere/></Shape></Scene></X3D>");

    make(scene, "A", new Goal.Polygons(100));

    assertThat(scene)
        .content()
        .contains("<Switch DEF=\"Switch_A\" whichChoice=\"0\">")
        .contains("url='\"inlineNodes/A_v1.x3d\"'");
  }

  @Test
  void anAuthorsIndentationIsTakenUp() throws IOException {
    Path scene =
        scene(
            "<X3D version='3.3'>\n    <Scene>\n        <Shape DEF='A'><Sphere/></Shape>\n"
                + "    </Scene>\n</X3D>\n");

    make(scene, "A", new Goal.Polygons(100));

    assertThat(scene).content().contains("\n        <Switch ", "\n            <Inline ");
  }

  @Test
  void theNameOfAGeometryMeansItsShape() throws IOException {
    Path scene = scene("<X3D><Scene><Shape><Sphere DEF='Ball'/></Shape></Scene></X3D>");

    make(scene, "Ball", new Goal.Polygons(100));

    assertThat(scene).content().contains("Switch_Ball").doesNotContain("<Shape");
  }

  @Test
  void aModelInlinedFromElsewhereIsNamedFromTheNewPlace() throws IOException {
    Files.createDirectories(folder.resolve("models"));
    Files.writeString(
        folder.resolve("models/ball.x3d"), "<X3D><Scene><Shape><Sphere/></Shape></Scene></X3D>");
    Path scene = scene("<X3D><Scene><Inline DEF='Ball' url='\"models/ball.x3d\"'/></Scene></X3D>");

    VersionsEdit plan = make(scene, "Ball", new Goal.Polygons(100));

    assertThat(folder.resolve("inlineNodes/Ball_v1.x3d"))
        .content()
        .contains("url='\"../models/ball.x3d\"'");
    assertThat(plan.versions().get(0).polygons()).isEqualTo(960);
  }

  @Test
  void aMaterialFromOutsideTheObjectComesAlong() throws IOException {
    Path scene =
        scene(
            "<X3D><Scene><Shape><Appearance DEF='Blue'><Material diffuseColor='0 0 1'/>"
                + "</Appearance><Box/></Shape><Shape DEF='B'><Appearance USE='Blue'/><Sphere/>"
                + "</Shape></Scene></X3D>");

    make(scene, "B", new Goal.Polygons(100));

    assertThat(folder.resolve("inlineNodes/B_v1.x3d")).content().contains("diffuseColor='0 0 1'");
    assertThat(folder.resolve("inlineNodes/B_v2.x3d")).content().contains("diffuseColor='0 0 1'");
  }

  @ParameterizedTest
  @ValueSource(strings = {"Vase", "Switch_Vase", "Table"})
  void runAgainItUpdatesTheVersions(String name) throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    String original = Files.readString(folder.resolve("inlineNodes/Vase_v1.x3d"));

    make(scene, name, new Goal.Polygons(200), new Goal.Polygons(40));

    assertThat(scene).hasContent(CHANGED);
    assertThat(folder.resolve("inlineNodes/Vase_v1.x3d")).hasContent(original);
    assertThat(polygons("inlineNodes/Vase_v2.x3d")).isBetween(198, 202);
    assertThat(polygons("inlineNodes/Vase_v3.x3d")).isBetween(38, 42);
  }

  @Test
  void theSameAgainChangesNoFile() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");

    VersionsEdit again = make(scene, "Vase");

    assertThat(again.scene().state()).isEqualTo(PlannedFile.State.UNCHANGED);
    assertThat(again.files())
        .extracting(PlannedFile::state)
        .containsOnly(PlannedFile.State.UNCHANGED);
  }

  @Test
  void moreOrFewerVersionsChangeTheInlinesOnly() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    String third = "        <Inline DEF='Inline_Vase_v3' url='\"inlineNodes/Vase_v3.x3d\"'/>\n";

    make(scene, "Vase", new Goal.Polygons(200));
    assertThat(scene).hasContent(CHANGED.replace(third, ""));

    make(scene, "Vase");
    assertThat(scene).hasContent(CHANGED);
  }

  @Test
  void allOfTheOriginalIsVersionOne() throws IOException {
    VersionsEdit plan =
        make(scene(SCENE), "Vase", new Goal.VertexPercent(100), new Goal.VertexPercent(10));

    assertThat(plan.versions()).hasSize(2);
  }

  @Test
  void aPlanWritesNothing() throws IOException {
    Path scene = scene(SCENE);
    Map<Path, String> before = files();

    VersionsEdit plan = plan(scene, "Vase", new Goal.Polygons(100)).orElseThrow();

    assertThat(files()).isEqualTo(before);
    assertThat(plan.changes()).hasSize(1);
    assertThat(plan.changes().get(0).line()).isEqualTo(8);
    assertThat(plan.changes().get(0).before()).startsWith("      <Shape   DEF='Vase'>");
  }

  @Test
  void anotherFileMayTakeTheChangedScene() throws IOException {
    Path scene = scene(SCENE);
    Path output = folder.resolve("changed.x3d");

    plan(new VersionsEdit.Request(scene, "Vase", GOALS, output, "inlineNodes"))
        .orElseThrow()
        .write(FileActions.REAL);

    assertThat(scene).hasContent(SCENE);
    assertThat(output).hasContent(CHANGED);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "Nobody | <Shape DEF='A'><Box/></Shape> | no node with DEF 'Nobody'",
        "A | <Shape DEF='A'><Box/></Shape><Shape USE='A'/> | 'A' is used here (USE)",
        "A | <Group DEF='A'><Shape DEF='B'><Box/></Shape></Group><Shape USE='B'/> | "
            + "'B' is used here (USE)",
        "A | <Group DEF='A'><Shape><Box/></Shape></Group><Group USE='A'/> | 'A' is "
            + "used here (USE)",
        "A | <Shape DEF='A'><Box/></Shape><Shape DEF='A'><Box/></Shape> | of several nodes",
        "A | <Shape DEF='A'><Box/></Shape><TouchSensor DEF='T'/><ROUTE fromNode='T' "
            + "fromField='isOver' toNode='A' toField='visible'/> | ROUTE here refers to 'A'",
        "A | <Shape DEF='A'><Appearance/></Shape> | the object 'A' has no faces",
        "A | <Group DEF='A'><Viewpoint/></Group> | the object 'A' has no faces",
        "A | <Viewpoint DEF='A'/> | the object 'A' has no faces",
        "A | <Switch DEF='A'><Shape><Box/></Shape></Switch> | has a Switch already",
        "A | <Shape DEF='A'><IndexedFaceSet/></Shape> | the object 'A' has no faces",
      })
  void whatCannotBeReplacedIsLeftAsItIs(String object, String content, String message)
      throws IOException {
    Path scene = scene("<X3D version='4.0'><Scene>" + content + "</Scene></X3D>");
    Map<Path, String> before = files();

    assertThat(plan(scene, object, new Goal.Polygons(6))).isEmpty();

    assertThat(problems.list().toString()).contains(message).contains("scene.x3d");
    assertThat(files()).isEqualTo(before);
  }

  @Test
  void moreThanTheOriginalHasIsRefused() throws IOException {
    assertThat(plan(scene(SCENE), "Vase", new Goal.Polygons(961))).isEmpty();
    assertThat(problems.list().toString()).contains("'Vase' has 960 polygons");
  }

  @Test
  void aFolderOutOfReachIsRefused() throws IOException {
    Path scene = scene(SCENE);

    assertThat(plan(new VersionsEdit.Request(scene, "Vase", GOALS, scene, "../elsewhere")))
        .isEmpty();
    assertThat(problems.list().toString()).contains("outside the scene's folder");
  }

  @Test
  void textThatIsNotWellFormedIsNotTouched() throws IOException {
    Path scene = scene(SCENE.replace("</Shape>", ""));

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> plan(scene, "Vase", new Goal.Polygons(6)))
        .withMessageContaining("scene.x3d:");
  }

  @Test
  void bytesThatAreNoTextAreNotTouched() throws IOException {
    byte[] bytes = SCENE.getBytes(UTF_8);
    bytes[Arrays.asList(SCENE.split("")).indexOf("ß") + 1] = (byte) 0xff;
    Path scene = scene(bytes);

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> plan(scene, "Vase", new Goal.Polygons(6)))
        .withMessageContaining("not changed");
    assertThat(scene).hasBinaryContent(bytes);
  }

  @Test
  void namesThatNoFileMayHaveAreReplaced() throws IOException {
    make(scene(SCENE.replace("'Vase'", "'a/../b:c'")), "a/../b:c");

    assertThat(folder.resolve("inlineNodes/a_.._b_c_v1.x3d")).exists();
  }

  private static String shape(String def, String geometry) {
    return "  <Shape DEF='" + def + "'>" + geometry + "</Shape>\n";
  }

  private Path other(String name, String content) throws IOException {
    return Files.writeString(
        folder.resolve(name), "<X3D version='3.3'><Scene>\n" + content + "</Scene></X3D>\n");
  }

  @Test
  void anotherScenesObjectOfTheSameNameKeepsItsFiles() throws IOException {
    Path a = other("a.x3d", shape("Sh", "<Sphere/>"));
    Path b = other("b.x3d", shape("Sh", "<Cone/>"));
    make(a, "Sh", new Goal.VertexPercent(10));
    String original = Files.readString(folder.resolve("inlineNodes/Sh_v1.x3d"));

    make(b, "Sh", new Goal.VertexPercent(50));

    assertThat(folder.resolve("inlineNodes/Sh_v1.x3d")).hasContent(original);
    assertThat(folder.resolve("inlineNodes/Sh2_v1.x3d")).content().contains("<Cone");
    assertThat(b).content().contains("\"inlineNodes/Sh2_v1.x3d\"", "\"inlineNodes/Sh2_v2.x3d\"");
    assertThat(problems.list().toString()).contains("Sh_v1.x3d", "Sh2_v1.x3d");
    assertThat(problems.any()).isFalse();
  }

  @Test
  void namesThatComeToTheSameFileNameGetFilesOfTheirOwn() throws IOException {
    Path scene = other("s.x3d", shape("A/b", "<Sphere/>") + shape("A_b", "<Cone/>"));
    make(scene, "A/b", new Goal.VertexPercent(10));

    make(scene, "A_b", new Goal.VertexPercent(50));

    assertThat(folder.resolve("inlineNodes/A_b_v1.x3d")).content().contains("<Sphere");
    assertThat(folder.resolve("inlineNodes/A_b2_v1.x3d")).content().contains("<Cone");
  }

  @ParameterizedTest
  @ValueSource(strings = {"Vase_v1.x3d", "Vase_v2.x3d"})
  void aFileByHandIsNotReplaced(String name) throws IOException {
    Files.createDirectories(folder.resolve("inlineNodes"));
    Path hand = Files.writeString(folder.resolve("inlineNodes").resolve(name), "by hand");

    make(scene(SCENE), "Vase");

    assertThat(hand).hasContent("by hand");
    assertThat(folder.resolve("inlineNodes/Vase2_v3.x3d")).exists();
  }

  @Test
  void anotherTryWithTheSameSceneUpdatesItsOwnFiles() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", new Goal.Polygons(200));
    scene(SCENE);

    make(scene, "Vase", new Goal.Polygons(100));

    assertThat(polygons("inlineNodes/Vase_v2.x3d")).isBetween(98, 102);
    assertThat(folder.resolve("inlineNodes/Vase2_v1.x3d")).doesNotExist();
  }

  @Test
  void aFurtherVersionDoesNotReplaceAFileByHand() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", new Goal.Polygons(200));
    Path hand = Files.writeString(folder.resolve("inlineNodes/Vase_v3.x3d"), "by hand");

    assertThat(plan(scene, "Vase", new Goal.Polygons(200), new Goal.Polygons(90))).isEmpty();

    assertThat(problems.list().toString()).contains("Vase_v3.x3d");
    assertThat(hand).hasContent("by hand");
  }

  private static String metadata(int versions) {
    return "      <MetadataSet containerField='metadata' name='Vase'>\n"
        + "        <MetadataSet containerField='value' name='one'/>\n".repeat(versions)
        + "      </MetadataSet>\n";
  }

  @Test
  void aVersionThatIsShownDoesNotGo() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    Files.writeString(scene, CHANGED.replace("whichChoice='0'", "whichChoice='2'"));
    Map<Path, String> before = files();

    assertThat(plan(scene, "Vase", new Goal.Polygons(200))).isEmpty();

    assertThat(problems.list().toString()).contains("scene.x3d:8:").contains("whichChoice");
    assertThat(files()).isEqualTo(before);
  }

  @Test
  void aVersionWithMetadataDoesNotGo() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    String open = "<Switch DEF='Switch_Vase' whichChoice='0'>\n";
    Files.writeString(scene, CHANGED.replace(open, open + metadata(3)));

    assertThat(plan(scene, "Vase", new Goal.Polygons(200))).isEmpty();
    assertThat(problems.list().toString()).contains("scene.x3d:12:").contains("metadata");

    Files.writeString(scene, CHANGED.replace(open, open + metadata(2)));
    assertThat(plan(scene, "Vase", new Goal.Polygons(200))).isPresent();
  }

  @Test
  void aVersionWithARouteDoesNotGo() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    Files.writeString(
        scene,
        CHANGED.replace(
            "</Scene>",
            "<ROUTE fromNode='Touch' fromField='isOver' toNode='Inline_Vase_v3'"
                + " toField='load'/></Scene>"));

    assertThat(plan(scene, "Vase", new Goal.Polygons(200))).isEmpty();
    assertThat(problems.list().toString()).contains("Inline_Vase_v3");
  }

  @Test
  void aFileThatIsNoLongerUsedIsNamed() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");

    make(scene, "Vase", new Goal.Polygons(200));

    assertThat(problems.list().toString()).contains("Vase_v3.x3d").contains("no longer");
    assertThat(folder.resolve("inlineNodes/Vase_v3.x3d")).exists();
  }

  @Test
  void inAnotherFolderAnObjectWithVersionsHasAllOfThem() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    Path output = folder.resolve("copy/changed.x3d");

    plan(new VersionsEdit.Request(scene, "Vase", GOALS, output, "inlineNodes"))
        .orElseThrow()
        .write(FileActions.REAL);

    assertThat(folder.resolve("copy/inlineNodes/Vase_v1.x3d"))
        .hasSameBinaryContentAs(folder.resolve("inlineNodes/Vase_v1.x3d"));
    assertThat(polygons("copy/changed.x3d")).isEqualTo(960);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void inAnotherFolderWhatElseTheSceneNamesIsSaidToBeMissing() throws IOException {
    Path scene =
        other(
            "s.x3d",
            shape("Vase", "<Sphere/>")
                + "  <Shape><Appearance><ImageTexture url='\"wood.png\"'/></Appearance>"
                + "<Box/></Shape>\n");
    VersionsEdit.Request request =
        new VersionsEdit.Request(scene, "Vase", GOALS, folder.resolve("copy/s.x3d"), "inlineNodes");

    assertThat(plan(request)).isPresent();

    assertThat(problems.any()).isTrue();
    assertThat(problems.list().toString()).contains("s.x3d:3:").contains("wood.png");
  }

  @Test
  void anObjectNamedLikeAVersionKeepsItsName() throws IOException {
    Path scene = other("s.x3d", shape("Car_v2", "<Sphere/>"));
    make(scene, "Car_v2", new Goal.VertexPercent(10));

    make(scene, "Car_v2", new Goal.VertexPercent(10), new Goal.VertexPercent(30));

    assertThat(scene)
        .content()
        .contains("<Inline DEF='Inline_Car_v2_v3' url='\"inlineNodes/Car_v2_v3.x3d\"'/>");
    assertThat(folder.resolve("inlineNodes/Car_v2_v3.x3d")).exists();
  }

  @Test
  void aFurtherInlineHasANameOfItsOwn() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", new Goal.Polygons(200));
    Files.writeString(
        scene,
        Files.readString(scene)
            .replace("DEF='Inline_Vase_v2'", "DEF='Low'")
            .replace("DEF='Touch'", "DEF='Low_v3'"));

    make(scene, "Vase", new Goal.Polygons(200), new Goal.Polygons(90));

    assertThat(scene)
        .content()
        .contains("<Inline DEF='Low_v3_2' url='\"inlineNodes/Vase_v3.x3d\"'/>");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<PointLight/> | PointLight",
        "<Viewpoint/> | Viewpoint",
        "<TouchSensor/> | TouchSensor",
        "<Billboard><Shape><Box/></Shape></Billboard> | Billboard",
        "<Switch whichChoice='0'><Shape><Box/></Shape><Shape><Cone/></Shape></Switch> | Switch",
        "<LOD range='5'><Shape><Box/></Shape><Shape><Cone/></Shape></LOD> | LOD",
      })
  void whatReducedVersionsDoNotHaveIsSaid(String content, String node) throws IOException {
    Path scene =
        other(
            "s.x3d",
            "<Group DEF='A'><Group>\n    <Shape><Sphere/></Shape>\n    "
                + content
                + "\n</Group></Group>\n");

    assertThat(plan(scene, "A", new Goal.Polygons(100))).isPresent();

    assertThat(problems.list().toString()).contains("s.x3d:4:5").contains("the " + node + " here");
  }

  @Test
  void moreThanOnePolygonIsSaidAsOneSays() throws IOException {
    Path scene =
        other(
            "s.x3d",
            shape("A", "<TriangleSet><Coordinate point='0 0 0 1 0 0 0 1 0'/></TriangleSet>"));

    assertThat(plan(scene, "A", new Goal.Polygons(2))).isEmpty();
    assertThat(problems.list().toString()).contains("has 1 polygon and 3 vertices");
  }

  @Test
  void aCompressedOutputIsCompressed() throws IOException {
    Path output = folder.resolve("out.x3dz");

    plan(new VersionsEdit.Request(scene(SCENE), "Vase", GOALS, output, "inlineNodes"))
        .orElseThrow()
        .write(FileActions.REAL);

    try (GZIPInputStream in =
        new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(output)))) {
      assertThat(new String(in.readAllBytes(), UTF_8)).isEqualTo(CHANGED);
    }
  }
}
