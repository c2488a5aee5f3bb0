package org.selectiverenderer.app.head;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TrackerSilenceMeterTest {
  private final TrackerSilenceMeter silence = new TrackerSilenceMeter();

  @Test
  void aFrameThatTookLongIsNoSilenceOfTheTracker() {
    silence.frame(0, true);
    silence.frame(0.1, true);
    silence.frame(3, true);
    assertThat(silence.longest()).isZero();
  }

  @Test
  void theLongestTimeWithoutARecordCounts() {
    silence.frame(1, true);
    silence.frame(1.5, false);
    silence.frame(2.25, false);
    silence.frame(2.5, true);
    silence.frame(3, false);
    assertThat(silence.longest()).isEqualTo(1.25);
  }

  @Test
  void aTrackerThatNeverSaysAnythingIsSilentFromTheFirstFrame() {
    silence.frame(0.5, false);
    silence.frame(2.5, false);
    assertThat(silence.longest()).isEqualTo(2);
  }
}
