package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.ShowsWindows;

/** What the first frame does not wait for; the process is real. */
@ShowsWindows
class StartLinkageTest {
  @TempDir Path folder;

  /**
   * The JVM makes what a record compares and hashes itself by when that is first called, in a dozen
   * milliseconds for the first record and one or two for each further one, and no archive of
   * classes holds it. So the records that a start needs have theirs written out.
   */
  @Test
  void noRecordIsLinkedBeforeTheFirstFrame() throws Exception {
    Path said = folder.resolve("said.txt");
    Process run =
        new ProcessBuilder(
                ChildProcessCommand.of(
                    Main.class.getName(),
                    List.of("-Djava.lang.invoke.MethodHandle.TRACE_METHOD_LINKAGE=true"),
                    List.of(
                        "run",
                        "scenes/trashcan.x3d",
                        "--offscreen",
                        "--size",
                        "64x64",
                        "--duration",
                        "0.05")))
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();

    assertThat(run.waitFor(2, TimeUnit.MINUTES)).isTrue();

    List<String> links = Files.readAllLines(said, StandardCharsets.UTF_8);
    assertThat(run.exitValue()).isZero();
    assertThat(links).anyMatch(line -> line.contains("LambdaMetafactory"));
    assertThat(links.stream().filter(line -> line.contains("ObjectMethods")))
        .as("records whose equals or hashCode is not written out")
        .isEmpty();
  }
}
