package org.selectiverenderer.command.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.selectiverenderer.base.platform.ChildProcessCommand;

/** A command that is ended from outside. */
class InterruptHandlerTest {
  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "a process cannot be asked to end there")
  void endsEvenIfNeitherTheCommandNorALibraryDoes() throws IOException, InterruptedException {
    Process stuck =
        new ProcessBuilder(
                ChildProcessCommand.of(StuckCommand.class.getName(), List.of(), List.of()))
            .redirectErrorStream(true)
            .start();
    try (BufferedReader said = stuck.inputReader(StandardCharsets.UTF_8)) {
      assertThat(said.readLine()).isEqualTo(StuckCommand.BEGUN);
      stuck.toHandle().destroy(); // SIGTERM; what it says can still be read.
      assertThat(said.readLine()).isEqualTo("asked");
      assertThat(stuck.waitFor(60, TimeUnit.SECONDS)).isTrue();
      assertThat(stuck.exitValue()).isEqualTo(130);
    } finally {
      stuck.destroyForcibly();
    }
  }
}
