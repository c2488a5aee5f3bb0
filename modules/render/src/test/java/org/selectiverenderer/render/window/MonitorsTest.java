package org.selectiverenderer.render.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Monitors that the system describes wrongly, as Wine did two that stand side by side. */
class MonitorsTest {
  @Test
  void aModeThatCannotBeIsOneSentence() {
    assertThatThrownBy(
            () ->
                Monitors.explained(
                    () -> {
                      throw new IllegalArgumentException("resolution must be set");
                    }))
        .isInstanceOf(UncheckedIOException.class)
        .cause()
        .isInstanceOf(IOException.class)
        .hasMessageContaining("the monitors cannot be listed")
        .hasMessageContaining("(resolution must be set)")
        .hasMessageContaining("display settings");
  }

  @Test
  void whatCanBeListedIsListed() {
    MonitorMode mode = new MonitorMode(new Monitor(0, 0, "one", 0, 0, 1024, 768), 60, 1);
    assertThat(Monitors.explained(() -> List.of(mode))).containsExactly(mode);
  }
}
