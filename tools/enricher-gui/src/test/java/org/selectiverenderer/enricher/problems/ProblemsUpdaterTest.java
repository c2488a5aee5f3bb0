package org.selectiverenderer.enricher.problems;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class ProblemsUpdaterTest {
  @Test
  void thePauseBeforeChecksIsAsLongAsTheyTakeWithinBounds() {
    assertThat(ProblemsUpdater.pauseMs(0)).isEqualTo(900);
    assertThat(ProblemsUpdater.pauseMs(TimeUnit.MILLISECONDS.toNanos(2500))).isEqualTo(2500);
    assertThat(ProblemsUpdater.pauseMs(TimeUnit.HOURS.toNanos(2000))).isEqualTo(5000);
  }
}
