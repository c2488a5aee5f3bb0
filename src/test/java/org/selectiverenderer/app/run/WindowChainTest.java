package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.app.figures.RunFigures;
import org.selectiverenderer.app.head.ChainTracker;

class WindowChainTest {
  /** Would go on for ever. */
  private static final class Endless implements WindowChain.Runs {
    private int asked;

    @Override
    public Optional<GuidedRun> next() {
      asked++;
      throw new AssertionError("nothing begins after the end");
    }

    @Override
    public void ended(GuidedRun run, RunFigures figures) {
      throw new AssertionError("nothing has ended");
    }
  }

  @Test
  void whenTheProcessIsEndedNoFurtherRunBegins() {
    Endless runs = new Endless();
    RunStop stop = new RunStop();
    WindowChain chain = new WindowChain(runs, new ChainTracker(), Optional.empty(), stop);
    assertThat(chain.finished()).isFalse();
    stop.stop();
    assertThat(chain.step()).isEmpty();
    assertThat(chain.finished()).isTrue();
    assertThat(runs.asked).isZero();
  }
}
