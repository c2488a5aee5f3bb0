package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.metrics.RunMetrics;

class RunSequenceTest {
  /** Would go on for ever. */
  private static final class Endless implements RunSequence.Runs {
    private int asked;

    @Override
    public Optional<RunRequest> next() {
      asked++;
      throw new AssertionError("nothing begins after the end");
    }

    @Override
    public void ended(RunRequest run, RunMetrics figures) {
      throw new AssertionError("nothing has ended");
    }
  }

  @Test
  void whenTheProcessIsEndedNoFurtherRunBegins() {
    Endless runs = new Endless();
    RunCancellation stop = new RunCancellation();
    RunSequence chain = new RunSequence(runs, new SharedHeadTracker(), Optional.empty(), stop);
    assertThat(chain.finished()).isFalse();
    stop.stop();
    assertThat(chain.step()).isEmpty();
    assertThat(chain.finished()).isTrue();
    assertThat(runs.asked).isZero();
  }
}
