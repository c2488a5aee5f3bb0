package org.selectiverenderer.command.output;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

class CommandFileCheckTest {
  private static final Path NULL_DEVICE = Path.of(OS.WINDOWS.isCurrentOs() ? "NUL" : "/dev/null");

  @TempDir private Path folder;

  @Test
  void whatIsReadIsNotWrittenOverByWhateverName() throws IOException {
    Path path = Files.writeString(folder.resolve("path.csv"), "t,x,y,z\n");
    assertWouldOverwrite(path, path);
    assertWouldOverwrite(path, folder.resolve("./path.csv"));
  }

  @Test
  @RequiresSymbolicLinks
  void whatIsReadIsNotWrittenOverByALink() throws IOException {
    Path path = Files.writeString(folder.resolve("path.csv"), "t,x,y,z\n");
    assertWouldOverwrite(path, Files.createSymbolicLink(folder.resolve("link.csv"), path));
  }

  private static void assertWouldOverwrite(Path path, Path output) {
    assertThatThrownBy(
            () -> new CommandFileCheck().reads("--path", path).writes("--head-log", output).check())
        .isInstanceOf(CommandException.class)
        .hasMessageContaining("would overwrite --path");
  }

  @Test
  void noTwoOutputsAreOneFile() {
    Path one = folder.resolve("p01.json");
    assertThatThrownBy(
            () ->
                new CommandFileCheck()
                    .writes("--stats", one)
                    .writes("--head-log", folder.resolve("./p01.json"))
                    .check())
        .isInstanceOf(CommandException.class)
        .hasMessageContaining("is written by --stats");
  }

  @Test
  void othersAreLetBe() {
    assertThatCode(
            () ->
                new CommandFileCheck()
                    .reads("--path", null)
                    .reads("the scene", folder.resolve("scene.x3d"))
                    .writes("--stats", folder.resolve("p01.json"))
                    .writes("--timeline", NULL_DEVICE)
                    .writes("--screenshot", NULL_DEVICE)
                    .check())
        .doesNotThrowAnyException();
  }
}
