package org.selectiverenderer.enricher.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;

/** What ends the enricher from outside ends the windows of its runs; all processes are real. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class RunTerminationTest {
  private static final long PATIENCE = 60;

  @TempDir Path folder;

  @Test
  void aRunEndsWithTheProcessThatStartedItAndItsLogsAreWhole() throws Exception {
    Path log = folder.resolve("walk.csv");
    Path timeline = folder.resolve("walk.jsonl");
    Process enricher = starting(log, timeline);
    try (BufferedReader said = enricher.inputReader(StandardCharsets.UTF_8)) {
      String number = said.readLine();
      assertThat(number).as("the run's number").isNotNull();
      long pid = Long.parseLong(number);
      ProcessHandle run = ProcessHandle.of(pid).orElseThrow();
      try {
        // The log is written four times a second once the scene is shown.
        Eventually.await(
            "the head log",
            () -> {
              assertThat(run.isAlive()).as("the run").isTrue();
              return Files.exists(log) && Files.size(log) >= 500;
            });
        enricher.destroyForcibly(); // Nothing of it is asked any more.
        run.onExit().get(PATIENCE, TimeUnit.SECONDS);
        assertThat(run.isAlive()).isFalse();
      } finally {
        run.destroyForcibly();
      }
    } finally {
      enricher.destroyForcibly();
    }
    List<String> events = Files.readAllLines(timeline);
    assertThat(events.get(events.size() - 1)).contains("\"event\":\"end\"");
    assertThat(log).content().endsWith("\n");
  }

  private static Process starting(Path log, Path timeline) throws IOException {
    List<String> words =
        List.of(
            "run",
            "scenes/trashcan.x3d",
            "--size",
            "200x150",
            "--head-log",
            log.toString(),
            "--timeline",
            timeline.toString());
    return new ProcessBuilder(ChildProcessCommand.of(RunStarter.class.getName(), List.of(), words))
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }
}
