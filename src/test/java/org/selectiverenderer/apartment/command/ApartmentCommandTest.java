package org.selectiverenderer.apartment.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

class ApartmentCommandTest extends CommandTestCase {
  @TempDir private Path folder;

  @Test
  void someObjectsAreWrittenAlone() throws IOException {
    assertThat(execute("apartment", folder.toString(), "--only", "trashCan,shovel")).isZero();

    assertThat(folder.resolve("inlineNodes"))
        .isDirectoryContaining("glob:**/trashCan_v1.x3d")
        .isDirectoryContaining("glob:**/trashCan_v2.x3d")
        .isDirectoryContaining("glob:**/shovel.x3d");
    assertThat(folder.resolve("scenes")).doesNotExist();
    assertThat(messages())
        .contains("trashCan_v1.x3d: 1064 polygons", "trashCan_v2.x3d: 93 polygons");
  }

  @Test
  void anObjectWithoutARecipeIsOneSentence() {
    assertThat(execute("apartment", folder.toString(), "--only", "trashCan,unicorn")).isEqualTo(2);

    assertThat(messages())
        .contains("--only: the apartment has no object named unicorn")
        .doesNotContain("Exception");
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void aFileInTheWayOfTheFolderIsOneSentence() throws IOException {
    Files.writeString(folder.resolve("inlineNodes"), "in the way");

    assertThat(execute("apartment", folder.toString(), "--only", "trashCan")).isEqualTo(2);
    assertThat(messages()).contains("inlineNodes").doesNotContain("Exception:");
  }

  @Test
  void whatTheAuthorHasChangedIsNotReplacedUnlessForced() throws IOException {
    execute("apartment", folder.toString(), "--only", "trashCan");
    Path changed = folder.resolve("inlineNodes/trashCan_v2.x3d");
    String made = Files.readString(changed);
    Files.writeString(changed, "mine");

    assertThat(execute("apartment", folder.toString(), "--only", "trashCan,shovel")).isEqualTo(2);

    assertThat(changed).hasContent("mine");
    assertThat(folder.resolve("inlineNodes/shovel.x3d")).doesNotExist();
    assertThat(messages()).contains("trashCan_v2.x3d", "--force").doesNotContain("Exception");

    assertThat(execute("apartment", folder.toString(), "--only", "trashCan", "--force")).isZero();
    assertThat(changed).hasContent(made);
  }

  @Test
  void theSameAgainIsNoReplacement() {
    assertThat(execute("apartment", folder.toString(), "--only", "trashCan")).isZero();
    assertThat(execute("apartment", folder.toString(), "--only", "trashCan")).isZero();
  }

  @Test
  void aFileThatCannotBeWrittenIsNamedAndNoOtherIsLeft() throws IOException {
    Files.createDirectories(folder.resolve("inlineNodes/trashCan_v2.x3d"));

    assertThat(execute("apartment", folder.toString(), "--only", "shovel,trashCan", "--force"))
        .isEqualTo(2);

    assertThat(messages()).contains("trashCan_v2.x3d", "nothing has been changed");
    assertThat(folder.resolve("inlineNodes")).isDirectoryNotContaining("glob:**/*_v1.x3d");
    assertThat(folder.resolve("inlineNodes")).isDirectoryNotContaining("glob:**/shovel.x3d");
  }
}
