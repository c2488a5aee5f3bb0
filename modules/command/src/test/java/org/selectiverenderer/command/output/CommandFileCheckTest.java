package org.selectiverenderer.command.output;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CommandFileCheckTest {
  @TempDir private Path folder;

  @Test
  void whatIsReadIsNotWrittenOverByWhateverName() throws IOException {
    Path path = Files.writeString(folder.resolve("path.csv"), "t,x,y,z\n");
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), path);
    for (Path output : new Path[] {path, link, folder.resolve("./path.csv")}) {
      assertThatThrownBy(
              () ->
                  new CommandFileCheck().reads("--path", path).writes("--head-log", output).check())
          .isInstanceOf(CommandException.class)
          .hasMessageContaining("would overwrite --path");
    }
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
                    .writes("--timeline", Path.of("/dev/null"))
                    .writes("--screenshot", Path.of("/dev/null"))
                    .check())
        .doesNotThrowAnyException();
  }
}
