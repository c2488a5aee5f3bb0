package org.selectiverenderer.app.headset;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.ShowsWindows;

/** A run in a headset that is ended from outside (Ctrl-C, a session that logs out). */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class HeadsetInterruptTest {
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "a process cannot be asked to end there")
  @ParameterizedTest(name = "after frame {0}")
  @ValueSource(ints = {1, 4, 30}) // The window on the desktop opens during the first frames.
  void endsAsIfItsWindowWereClosed(int frame) throws IOException, InterruptedException {
    Process run =
        new ProcessBuilder(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                InterruptedHeadsetRun.class.getName(),
                "scenes/trashcan.x3d",
                Integer.toString(frame))
            .redirectErrorStream(true)
            .start();
    try (BufferedReader said = run.inputReader(StandardCharsets.UTF_8)) {
      assertThat(said.lines().anyMatch(InterruptedHeadsetRun.SHOWN::equals)).isTrue();
      run.toHandle().destroy(); // SIGTERM, where there are signals; what it says can still be read.
      List<String> rest = said.lines().toList();
      assertThat(rest).containsExactly(InterruptedHeadsetRun.ENDED);
      run.waitFor();
    }
  }
}
