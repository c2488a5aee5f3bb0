package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;

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
}
