package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Versions made again, and other ones, of an object that has some. */
class VersionUpdateTest extends VaseScene {
  private static String metadata(int versions) {
    return "      <MetadataSet containerField='metadata' name='Vase'>\n"
        + "        <MetadataSet containerField='value' name='one'/>\n".repeat(versions)
        + "      </MetadataSet>\n";
  }

  @ParameterizedTest
  @ValueSource(strings = {"Vase", "Switch_Vase", "Table"})
  void runAgainItUpdatesTheVersions(String name) throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    String original = Files.readString(folder.resolve("inlineNodes/Vase_v1.x3d"));

    make(
        scene, name, new SimplificationTarget.Polygons(200), new SimplificationTarget.Polygons(40));

    assertThat(scene).usingCharset(StandardCharsets.UTF_8).hasContent(CHANGED);
    assertThat(folder.resolve("inlineNodes/Vase_v1.x3d"))
        .usingCharset(StandardCharsets.UTF_8)
        .hasContent(original);
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

    make(scene, "Vase", new SimplificationTarget.Polygons(200));
    assertThat(scene).usingCharset(StandardCharsets.UTF_8).hasContent(CHANGED.replace(third, ""));

    make(scene, "Vase");
    assertThat(scene).usingCharset(StandardCharsets.UTF_8).hasContent(CHANGED);
  }

  @Test
  void aVersionThatIsShownDoesNotGo() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    Files.writeString(scene, CHANGED.replace("whichChoice='0'", "whichChoice='2'"));
    Map<Path, String> before = files();

    assertThat(plan(scene, "Vase", new SimplificationTarget.Polygons(200))).isEmpty();

    assertThat(problems.list().toString()).contains("scene.x3d:8:").contains("whichChoice");
    assertThat(files()).isEqualTo(before);
  }

  @Test
  void aVersionWithMetadataDoesNotGo() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");
    String open = "<Switch DEF='Switch_Vase' whichChoice='0'>\n";
    Files.writeString(scene, CHANGED.replace(open, open + metadata(3)));

    assertThat(plan(scene, "Vase", new SimplificationTarget.Polygons(200))).isEmpty();
    assertThat(problems.list().toString()).contains("scene.x3d:12:").contains("metadata");

    Files.writeString(scene, CHANGED.replace(open, open + metadata(2)));
    assertThat(plan(scene, "Vase", new SimplificationTarget.Polygons(200))).isPresent();
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

    assertThat(plan(scene, "Vase", new SimplificationTarget.Polygons(200))).isEmpty();
    assertThat(problems.list().toString()).contains("Inline_Vase_v3");
  }

  @Test
  void aFileThatIsNoLongerUsedIsNamed() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase");

    make(scene, "Vase", new SimplificationTarget.Polygons(200));

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
        .write();

    assertThat(folder.resolve("copy/inlineNodes/Vase_v1.x3d"))
        .hasSameBinaryContentAs(folder.resolve("inlineNodes/Vase_v1.x3d"));
    assertThat(polygons("copy/changed.x3d")).isEqualTo(960);
    assertThat(problems.list()).isEmpty();
  }
}
