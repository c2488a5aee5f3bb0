package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

/** The scenes that are measured, for other browsers. */
class BenchScenesTest extends CommandTestCase {
  private @TempDir Path dir;

  @Test
  void theyAreWrittenWithTheirObjectsInsteadOfMeasuring() throws IOException {
    assertThat(execute("bench", "--scenes", dir.toString())).as(messages()).isZero();
    Path heavy = dir.resolve("heavy");
    Path light = dir.resolve("light");
    assertThat(printed().lines())
        .containsExactly(
            heavy.resolve("scene.x3d").toString(), light.resolve("scene.x3d").toString());
    assertThat(heavy.resolve("objects").resolve("object69.x3d")).isRegularFile();
    assertThat(Files.size(heavy.resolve("objects").resolve("object00.x3d")))
        .isGreaterThan(5 * Files.size(light.resolve("objects").resolve("object00.x3d")));
  }

  @Test
  void measuringAndWritingAtOnceIsRefused() {
    assertThat(execute("bench", "--scenes", dir.toString(), "--growth")).isEqualTo(2);
    assertThat(messages()).contains("--scenes does not measure");
    assertThat(dir).isEmptyDirectory();
  }
}
