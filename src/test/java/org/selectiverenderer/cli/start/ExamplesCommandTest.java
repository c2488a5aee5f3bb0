package org.selectiverenderer.cli.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

class ExamplesCommandTest extends CommandTestCase {
  @TempDir Path folder;

  @Test
  void itWritesScenesThatTheValidatorReadsAndListsThem() throws IOException {
    Path target = folder.resolve("my examples");
    assertThat(execute("examples", target.toString())).isZero();
    List<String> listed = printed().lines().toList();
    try (Stream<Path> files = Files.walk(target)) {
      assertThat(listed)
          .containsExactlyInAnyOrderElementsOf(
              files.filter(Files::isRegularFile).map(Path::toString).toList());
    }
    assertThat(messages()).contains(listed.size() + " files written", " MB").hasLineCount(1);
    assertThat(execute("validate", target.resolve("scenes/apartment.x3d").toString()))
        .as(messages())
        .isZero();
    assertThat(execute("validate", target.resolve("docs/examples/sculptures.x3dv").toString()))
        .as(messages())
        .isZero();
    assertThat(execute("examples", target.toString())).isZero();
    assertThat(printed()).isEmpty();
    assertThat(messages()).contains("nothing is written");
  }

  @Test
  void itWritesNothingWhereAFileHasAnotherContent() throws IOException {
    Path mine = folder.resolve("scenes/trashcan.x3d");
    Files.createDirectories(mine.getParent());
    Files.writeString(mine, "mine");
    Files.writeString(folder.resolve("notes.txt"), "of something else");
    assertThat(execute("examples", folder.toString())).isEqualTo(2);
    assertThat(messages()).contains(mine + " is there already", "nothing is written");
    assertThat(mine).hasContent("mine");
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void aFileIsNoFolder() throws IOException {
    Path file = Files.writeString(folder.resolve("a"), "");
    assertThat(execute("examples", file.toString())).isEqualTo(2);
    assertThat(messages()).contains("is a file; name a folder");
  }
}
