package org.selectiverenderer.authoring.versions;

import static java.nio.charset.StandardCharsets.UTF_16LE;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** An object is replaced by a Switch of its versions, and nothing else changes. */
class VersionCreationTest extends VaseScene {
  private static byte[] bytes(
      String text, String encoding, Charset charset, String lineEnd, boolean mark) {
    String changed = text.replace("UTF-8", encoding).replace("\n", lineEnd);
    return ((mark ? "\ufeff" : "") + changed).getBytes(charset);
  }

  @Test
  void aSwitchOfInlinesTakesTheObjectsPlaceAndNothingElseChanges() throws IOException {
    Path scene = scene(SCENE);

    VersionsEdit plan = make(scene, "Vase");

    assertThat(scene)
        .usingCharset(UTF_8)
        .hasContent(CHANGED)
        .hasBinaryContent(CHANGED.getBytes(UTF_8));
    assertThat(plan.versions())
        .extracting(ObjectVersion::polygons)
        .startsWith(960)
        .hasSize(3)
        .isSortedAccordingTo((a, b) -> b - a);
  }

  @Test
  void theSceneAndTheFileOfVersion1DeclareTheComponentsThatTheirProfileLacks() throws IOException {
    String head = "  <head>\n    <component name='Grouping' level='2'/>\n";
    Path scene =
        scene(
            """
            <X3D profile='Interchange' version='3.3'>
            %s  </head>
              <Scene>
                <Group DEF='Set'>
                  <Shape><Sphere/></Shape>
                  <Inline url='"other.x3d"'/>
                </Group>
              </Scene>
            </X3D>
            """
                .formatted(head));
    other("other.x3d", shape("Ball", "<Sphere/>"));

    make(scene, "Set", new SimplificationTarget.VertexPercent(50));

    assertThat(scene)
        .content()
        .contains(head + "    <component name='Networking' level='2'/>\n  </head>")
        .contains("<Switch DEF='Switch_Set'");
    assertThat(folder.resolve("inlineNodes/Set_v1.x3d"))
        .content()
        .contains(
            "profile='Interchange'", "<head>\n    <component name='Networking' level='2'/>\n");
    assertThat(folder.resolve("inlineNodes/Set_v2.x3d"))
        .content()
        .contains("profile='Interchange'")
        .doesNotContain("<component");
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
        .usingCharset(UTF_8)
        .hasContent(CHANGED.replace("Switch_Vase", "Switch_Table").replace("Vase_v", "Table_v"));
  }

  @Test
  void severalShapesBecomeOneObject() throws IOException {
    Path scene =
        scene(
            "<X3D version='3.3'><Scene>\n  <Group DEF='Set'>\n    <Shape><Box/></Shape>\n"
                + "    <Viewpoint/>\n    <Shape><Sphere/></Shape>\n  </Group>\n</Scene></X3D>\n");

    make(scene, "Set", new SimplificationTarget.Polygons(100));

    assertThat(scene)
        .usingCharset(UTF_8)
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

    make(scene, "A", new SimplificationTarget.Polygons(100));

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

    make(scene, "A", new SimplificationTarget.Polygons(100));

    assertThat(scene).content().contains("\n        <Switch ", "\n            <Inline ");
  }

  @Test
  void theNameOfAGeometryMeansItsShape() throws IOException {
    Path scene = scene("<X3D><Scene><Shape><Sphere DEF='Ball'/></Shape></Scene></X3D>");

    make(scene, "Ball", new SimplificationTarget.Polygons(100));

    assertThat(scene).content().contains("Switch_Ball").doesNotContain("<Shape");
  }

  @Test
  void aModelInlinedFromElsewhereIsNamedFromTheNewPlace() throws IOException {
    Files.createDirectories(folder.resolve("models"));
    Files.writeString(
        folder.resolve("models/ball.x3d"), "<X3D><Scene><Shape><Sphere/></Shape></Scene></X3D>");
    Path scene = scene("<X3D><Scene><Inline DEF='Ball' url='\"models/ball.x3d\"'/></Scene></X3D>");

    VersionsEdit plan = make(scene, "Ball", new SimplificationTarget.Polygons(100));

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

    make(scene, "B", new SimplificationTarget.Polygons(100));

    assertThat(folder.resolve("inlineNodes/B_v1.x3d")).content().contains("diffuseColor='0 0 1'");
    assertThat(folder.resolve("inlineNodes/B_v2.x3d")).content().contains("diffuseColor='0 0 1'");
  }

  @Test
  void allOfTheOriginalIsVersionOne() throws IOException {
    VersionsEdit plan =
        make(
            scene(SCENE),
            "Vase",
            new SimplificationTarget.VertexPercent(100),
            new SimplificationTarget.VertexPercent(10));

    assertThat(plan.versions()).hasSize(2);
  }

  @Test
  void aPlanWritesNothing() throws IOException {
    Path scene = scene(SCENE);
    Map<Path, String> before = files();

    VersionsEdit plan = plan(scene, "Vase", new SimplificationTarget.Polygons(100)).orElseThrow();

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
        .write();

    assertThat(scene).usingCharset(UTF_8).hasContent(SCENE);
    assertThat(output).usingCharset(UTF_8).hasContent(CHANGED);
  }

  @Test
  void aCompressedOutputIsCompressed() throws IOException {
    Path output = folder.resolve("out.x3dz");

    plan(new VersionsEdit.Request(scene(SCENE), "Vase", GOALS, output, "inlineNodes"))
        .orElseThrow()
        .write();

    try (GZIPInputStream in =
        new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(output)))) {
      assertThat(new String(in.readAllBytes(), UTF_8)).isEqualTo(CHANGED);
    }
  }
}
