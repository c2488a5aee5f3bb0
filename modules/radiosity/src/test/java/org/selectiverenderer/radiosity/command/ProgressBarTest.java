package org.selectiverenderer.radiosity.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;

class ProgressBarTest {
  private final ByteArrayOutputStream messages = new ByteArrayOutputStream();
  private final PrintStream err = new PrintStream(messages, true, StandardCharsets.UTF_8);
  private final Console console = new Console(err, err, false);

  @Test
  void afterCtrlCWorkThatGoesOnIsWaitedFor() throws InterruptedException {
    Duration patience = Duration.ofMillis(250);
    ProgressBar bar = new ProgressBar(console, false, patience);
    Thread waiting = new Thread(bar::cancel);
    waiting.start();
    long until = System.nanoTime() + 3 * patience.toNanos();
    while (System.nanoTime() < until) {
      bar.at(RadiosityProgress.Stage.WRITING, 0.5);
      TimeUnit.MILLISECONDS.sleep(1);
    }
    assertThat(bar.cancelled()).isTrue();
    assertThat(waiting.isAlive()).isTrue();
    bar.close();
    waiting.join();
    assertThat(messages).hasToString("");
  }

  @Test
  void workThatStandsStillIsGivenUp() {
    try (ProgressBar bar = new ProgressBar(console, false, Duration.ofMillis(1))) {
      bar.cancel();
    }
    assertThat(messages.toString(StandardCharsets.UTF_8)).contains("did not stop");
  }
}
