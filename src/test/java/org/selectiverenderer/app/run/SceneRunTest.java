package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.clock.Pace;
import org.selectiverenderer.app.clock.Stopwatch;
import org.selectiverenderer.app.head.HeadSession;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.runtime.render.Drawn;

/** The time of a run, which what is recorded carries. */
class SceneRunTest {
  private static final RunListener QUIET =
      new RunListener() {
        @Override
        public void problem(Problem problem) {
          throw new AssertionError(problem);
        }

        @Override
        public void happened(TimelineEvent event) {
          // Nothing is enriched.
        }

        @Override
        public void printed(String text) {
          // Nothing prints.
        }
      };

  @TempDir private Path folder;
  private final AtomicLong nanos = new AtomicLong(7_000_000_000L);

  @Test
  void timeInAWindowBeginsWithTheFirstStep() throws IOException {
    try (SceneRun run = run(Pace.WATCHED)) {
      assertThat(stepped(run)).isZero();
      drawnAfterTwoSeconds(run);
      assertThat(stepped(run)).isEqualTo(2);
      drawnAfterTwoSeconds(run);
      assertThat(stepped(run)).isEqualTo(4);
      assertThat(run.finished()).isFalse();
      drawnAfterTwoSeconds(run);
      stepped(run);
      assertThat(run.finished()).isTrue();
    }
  }

  @Test
  void timeWithoutAWindowBeginsWithTheFirstPicture() throws IOException {
    try (SceneRun run = run(Pace.UNWATCHED)) {
      assertThat(stepped(run)).isZero();
      drawnAfterTwoSeconds(run);
      assertThat(stepped(run)).isZero();
      drawnAfterTwoSeconds(run);
      assertThat(stepped(run)).isEqualTo(2);
      drawnAfterTwoSeconds(run);
      assertThat(stepped(run)).isEqualTo(4);
      assertThat(run.finished()).isFalse();
    }
  }

  private SceneRun run(Pace pace) throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Immersive'><Scene><Shape><Box/></Shape></Scene></X3D>");
    RunSettings settings =
        new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
            .lasting(OptionalDouble.of(5));
    SceneRun run =
        new SceneRun(
            settings,
            QUIET,
            HeadSession.open(settings, QUIET::problem),
            RunGuide.USER,
            pace,
            new RunStop(),
            new Stopwatch(nanos::get));
    run.awaitScene();
    return run;
  }

  private static double stepped(SceneRun run) {
    return run.step().orElseThrow().time();
  }

  private void drawnAfterTwoSeconds(SceneRun run) {
    nanos.addAndGet(2_000_000_000L);
    run.drawn(new Drawn(1, 12));
    run.submitted();
  }
}
