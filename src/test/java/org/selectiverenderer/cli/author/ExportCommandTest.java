package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.cli.CommandTestCase;

class ExportCommandTest extends CommandTestCase {
  private static final String SCENE = "scenes/trashcan.x3d";

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"x3d", "x3dv", "json"})
  void theCopyIsValidAndHasTheTimeLineOfTheScene(String form) throws IOException {
    Path copy = folder.resolve("copy");
    assertThat(execute("export", SCENE, "--to", form, copy.toString())).as(messages()).isZero();
    Path scene = copy.resolve("trashcan." + form);
    assertThat(printed()).isEqualTo(scene + ": 12 other files\n");
    assertThat(copy.resolve("inlineNodes/trashCan_v1.x3d")).exists();
    assertThat(copy).isDirectoryNotContaining("glob:**/.*"); // of what was being written

    assertThat(execute("validate", scene.toString())).as(printed()).isZero();
    String path = "scenes/paths/desk-visit.csv";
    assertThat(execute("simulate", scene.toString(), "--path", path)).isZero();
    String walked = printed();
    assertThat(execute("simulate", SCENE, "--path", path)).isZero();
    assertThat(walked).isEqualTo(printed()).contains("DeskProx activates DeskSchema");
  }

  @Test
  void conditionAndSeedAreThoseOfTheCopy() throws IOException {
    Path copy = folder.resolve("copy");
    assertThat(
            execute(
                "export",
                SCENE,
                "--to",
                "x3d",
                copy.toString(),
                "--condition",
                "random",
                "--seed",
                "-3"))
        .as(messages())
        .isZero();
    assertThat(copy.resolve("trashcan.x3d"))
        .content()
        .contains("name=\"condition\" type=\"SFString\" value=\"random\"")
        .contains("name=\"seed\" type=\"SFInt32\" value=\"-3\"");
  }

  @Test
  void nothingIsWrittenWhereAFileIsMissing() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("room.x3d"),
            Files.readString(Path.of(SCENE))
                .replace("../inlineNodes/desk.x3d", "gone.x3d")
                .replace("../inlineNodes/", "files/"));
    Path copy = folder.resolve("copy");

    assertThat(execute("export", scene.toString(), "--to", "x3d", copy.toString())).isEqualTo(1);
    assertThat(messages()).contains("room.x3d", "gone.x3d", "the export would lack it");
    assertThat(copy).doesNotExist();
  }

  @Test
  void filesOfTheUserAreNotReplaced() throws IOException {
    Path copy = Files.createDirectories(folder.resolve("copy"));
    Path own = Files.writeString(copy.resolve("trashcan.x3d"), "mine");

    assertThat(execute("export", SCENE, "--to", "x3d", copy.toString())).isEqualTo(2);
    assertThat(messages()).contains("has another trashcan.x3d already");
    assertThat(own).hasContent("mine");
    assertThat(copy.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void aSeedThatTheScriptCannotHoldIsWrongUsage() {
    assertThat(
            execute(
                "export",
                SCENE,
                "--to",
                "x3d",
                folder.resolve("copy").toString(),
                "--seed",
                "3000000000"))
        .isEqualTo(2);
    assertThat(messages()).contains("--seed 3000000000", "32 bits");
  }

  /** A room whose only enriched object is in a prototype, to whose instance a ROUTE leads. */
  private Path prototype() throws IOException {
    return Files.writeString(
        folder.resolve("room.x3d"),
        """
        <X3D profile='Immersive' version='3.3'><Scene>
        <ProtoDeclare name='Bin'><ProtoBody>
        <Switch DEF='Versions' whichChoice='0'><MetadataSet DEF='Versions_Metadata' name='Metadata'>
        <MetadataSet name='choice 0' containerField='value'>
        <MetadataString containerField='value' name='schemaBelonginess' value='"Desk"'/></MetadataSet></MetadataSet>
        <Shape><Box/></Shape></Switch>
        </ProtoBody></ProtoDeclare>
        <ProtoInstance name='Bin' DEF='Mine'/><BooleanToggle DEF='Toggle'/>
        <ROUTE fromNode='Toggle' fromField='toggle' toNode='Mine' toField='visible'/>
        </Scene></X3D>
        """);
  }

  @Test
  void validateForExportSaysWhatAnExportCannotCarry() throws IOException {
    Path scene = prototype();
    execute("validate", scene.toString(), "--for-export");
    assertThat(printed())
        .contains(":8:1: error:", "SR801", "the prototype Bin, which has enriched nodes")
        .contains("room.x3d");
    execute("validate", scene.toString());
    assertThat(printed()).doesNotContain("SR801");
    execute("validate", scene.toString(), "--for-export", "--ignore", "SR8");
    assertThat(printed()).doesNotContain("SR801");
  }

  @Test
  void validateForExportFindsNothingInASceneThatCanBeExported() {
    assertThat(execute("validate", SCENE, "--for-export")).as(printed()).isZero();
    assertThat(printed()).doesNotContain("SR801", "SR802");
    assertThat(execute("validate", "--explain", "SR801")).isZero();
    assertThat(printed()).contains("an export cannot carry this");
  }

  @Test
  void withoutAScriptTheCopyIsValidAndHasFiltersAndTriggers() throws IOException {
    Path copy = folder.resolve("copy");
    assertThat(execute("export", SCENE, "--to", "x3d", copy.toString(), "--without-script"))
        .as(messages())
        .isZero();
    Path scene = copy.resolve("trashcan.x3d");
    assertThat(scene)
        .content()
        .contains("<BooleanFilter", "<IntegerTrigger")
        .doesNotContain("<Script");
    assertThat(execute("validate", scene.toString())).as(printed()).isZero();
  }

  @Test
  void withoutAScriptOnlyTheConditionSelectiveIsThere() {
    Path copy = folder.resolve("copy");
    String[] options = {"--to", "x3d", copy.toString(), "--without-script", "--condition", "high"};
    assertThat(execute(prepend("export", SCENE, options))).isEqualTo(2);
    assertThat(messages()).contains("--without-script", "selective");
    assertThat(copy).doesNotExist();
  }

  private static String[] prepend(String command, String scene, String... options) {
    String[] all = new String[options.length + 2];
    all[0] = command;
    all[1] = scene;
    System.arraycopy(options, 0, all, 2, options.length);
    return all;
  }

  @Test
  void aPageHasTheSceneCompressedAndSaysWhatItWeighs() throws IOException {
    Path site = folder.resolve("site");
    assumeTrue(
        ExportCommandTest.class.getResource("/org/selectiverenderer/web/files.txt") != null
            || System.getenv("SELECTIVE_RENDERER_REQUIRE_WEB") != null,
        "built without the page");
    assertThat(execute("export", SCENE, "--to", "web", site.toString())).as(messages()).isZero();
    assertThat(printed())
        .contains("index.html: a page for any web server", "in 13 files", "before compression")
        .doesNotContain(" 0.0 MB");
    assertThat(site.resolve("index.html")).content().contains("<x3d-canvas");
    assertThat(site.resolve("page/x_ite/LICENSE.md")).exists();
    assertThat(site.resolve("scene.json"))
        .content()
        .contains("\"title\" : \"Trash can\"", "\"file\" : \"scene/trashcan.x3dz\"")
        .contains("scene/inlineNodes/trashCan_v1.x3dz");
    Path scene = site.resolve("scene/trashcan.x3dz");
    assertThat(execute("validate", scene.toString())).as(printed()).isZero();
    String path = "scenes/paths/desk-visit.csv";
    assertThat(execute("simulate", scene.toString(), "--path", path)).isZero();
    // The page loads the other version when it is chosen; its polygons are not there before.
    assertThat(printed())
        .contains("DeskProx activates DeskSchema", "choice 1 -> 0", "13079 at most");
  }
}
