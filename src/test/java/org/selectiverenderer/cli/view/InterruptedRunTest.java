package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.HeadMotion;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator;
import org.selectiverenderer.tracker.emulator.PseudoTerminal.Maker;

/** A run that is ended from outside (Ctrl-C, a session that logs out) leaves whole files. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class InterruptedRunTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"--offscreen", "--operator"})
  void writesItsFiguresAndTheEndOfItsLogs(String kind) throws IOException, InterruptedException {
    assumeTrue(Stream.of(Maker.values()).anyMatch(Maker::installed), "no socat, no script");
    try (EmulatedInterTrax2 device =
        EmulatedInterTrax2.start(
            folder.resolve("tracker"),
            new InterTrax2Emulator.Settings(120, HeadMotion.LOOKING_ABOUT))) {
      Path messages = folder.resolve("messages");
      Process run =
          new ProcessBuilder(command(kind, device))
              .redirectErrorStream(true)
              .redirectOutput(messages.toFile())
              .start();
      Path log = folder.resolve("p01.csv");
      // The log is written four times a second once the scene is shown.
      Eventually.await(
          "the head log",
          () -> {
            assertThat(run.isAlive()).as(Files.readString(messages)).isTrue();
            return Files.exists(log) && Files.size(log) >= 2000;
          });
      run.destroy(); // SIGTERM, where there are signals.
      run.waitFor();
      assertThat(messages).content(StandardCharsets.UTF_8).doesNotContain("gone", "Exception");
      List<String> timeline = Files.readAllLines(folder.resolve("p01.jsonl"));
      assertThat(timeline.get(timeline.size() - 1)).contains("\"event\":\"end\"");
      assertThat(
              new ObjectMapper()
                  .readTree(folder.resolve("stats.json").toFile())
                  .get("frames")
                  .asInt())
          .isPositive();
      assertThat(folder.resolve("p01.png")).isNotEmptyFile();
      assertThat(log).content().endsWith("\n");
    }
  }

  private List<String> command(String kind, EmulatedInterTrax2 device) {
    List<String> command =
        new ArrayList<>(
            List.of(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "run",
                "scenes/trashcan.x3d",
                kind,
                "--size",
                "400x300",
                "--duration",
                "100",
                "--tracker",
                "intertrax2:" + device.link(),
                "--head-log",
                folder.resolve("p01.csv").toString(),
                "--timeline",
                folder.resolve("p01.jsonl").toString(),
                "--screenshot",
                folder.resolve("p01.png").toString(),
                "--stats",
                folder.resolve("stats.json").toString()));
    return command;
  }
}
