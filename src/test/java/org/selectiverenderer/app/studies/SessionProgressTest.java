package org.selectiverenderer.app.studies;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.session.JournalContent;

class SessionProgressTest {
  private static SessionProgress of(String... lines) {
    return SessionProgress.of(
        List.of("form", "exposure-a", "exposure-b", "main"),
        JournalContent.of((String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8))
            .events());
  }

  @Test
  void anEmptyJournalHasAllStepsOpen() {
    SessionProgress progress = of("");
    assertThat(progress.steps()).hasSize(4);
    assertThat(progress.done()).isZero();
    assertThat(progress.since()).isEmpty();
  }

  @Test
  void stepsComeInTheOrderInWhichTheyBeganAndTrialsAreCounted() {
    SessionProgress progress =
        of(
            "{\"event\":\"session-began\",\"time\":\"2026-01-02T03:04:05Z\"}",
            "{\"event\":\"step-began\",\"step\":\"form\"}",
            "{\"event\":\"step-finished\",\"step\":\"form\"}",
            "{\"event\":\"step-began\",\"step\":\"exposure-b\"}",
            "{\"event\":\"step-finished\",\"step\":\"exposure-b\"}",
            "{\"event\":\"step-began\",\"step\":\"main-001\",\"block\":\"main\",\"trial\":1}",
            "{\"event\":\"step-finished\",\"step\":\"main-001\",\"block\":\"main\",\"trial\":1}",
            "{\"event\":\"step-began\",\"step\":\"main-002\",\"block\":\"main\",\"trial\":2}",
            "{\"event\":\"flag\",\"flag\":\"tracker-lost\",\"step\":\"main-002\"}",
            "{\"event\":\"flag\",\"flag\":\"tracker-lost\",\"step\":\"main-003\"}");
    assertThat(progress.steps())
        .extracting(SessionProgress.Step::id)
        .containsExactly("form", "exposure-b", "main", "exposure-a");
    assertThat(progress.now())
        .contains(new SessionProgress.Step("main", SessionProgress.StepState.NOW, 1));
    assertThat(progress.flags()).containsExactly(SessionFlag.TRACKER_LOST);
  }

  @Test
  void aResumedSessionRunsAgain() {
    SessionProgress progress =
        of(
            "{\"event\":\"session-began\"}",
            "{\"event\":\"step-began\",\"step\":\"form\"}",
            "{\"event\":\"aborted\",\"step\":\"form\"}",
            "{\"event\":\"resumed\"}");
    assertThat(progress.state()).isEqualTo(SessionProgress.State.BEGUN);
    assertThat(progress.now()).as("nothing has begun since").isEmpty();
  }
}
