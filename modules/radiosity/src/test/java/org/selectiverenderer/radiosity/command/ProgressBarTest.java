package org.selectiverenderer.radiosity.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;

class ProgressBarTest {
  private final ByteArrayOutputStream messages = new ByteArrayOutputStream();
  private final PrintStream err = new PrintStream(messages, true, StandardCharsets.UTF_8);
  private final Console console = new Console(err, err, false);

  @Test
  void afterCtrlCWorkThatGoesOnIsWaitedFor() {
    List<ProgressBar> bars = new ArrayList<>();
    AtomicInteger waits = new AtomicInteger();
    ProgressBar bar =
        new ProgressBar(
            console,
            false,
            ended -> {
              if (waits.incrementAndGet() == 4) {
                bars.get(0).close();
              } else {
                bars.get(0).at(RadiosityProgress.Stage.WRITING, 0.5);
              }
              return ended.getCount() == 0;
            });
    bars.add(bar);
    bar.cancel();
    assertThat(bar.cancelled()).isTrue();
    assertThat(waits).hasValue(4);
    assertThat(messages).hasToString("");
  }

  @Test
  void workThatStandsStillIsGivenUp() {
    try (ProgressBar bar = new ProgressBar(console, false, ended -> false)) {
      bar.cancel();
    }
    assertThat(messages.toString(StandardCharsets.UTF_8)).contains("did not stop in time");
  }
}
