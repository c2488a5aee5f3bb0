package org.selectiverenderer.app.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.runtime.render.window.Monitor;

/** What of the operator has a place. */
class SessionStageTest {
  private static final Monitor LEFT = new Monitor(0, 0, "HDMI-1", 0, 0, 640, 480);
  private static final Monitor DESK = new Monitor(0, 2, "DP-1", 1280, 0, 1280, 1024);

  @Test
  void theOnlyMonitorIsTheParticipants() {
    assertThat(SessionStage.viewFits(List.of(DESK))).isFalse();
    assertThat(SessionStage.viewFits(List.of(DESK, LEFT))).isTrue();
  }
}
