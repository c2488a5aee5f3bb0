package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.clock.Stopwatch;
import org.selectiverenderer.app.clock.TimingMode;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.study.headlog.HeadLogReader;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

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
  private Path log = Path.of("");
  private final DimGuide guide = new DimGuide();
  private final AtomicLong nanos = new AtomicLong(7_000_000_000L);

  @Test
  void timeInAWindowBeginsWithTheFirstStep() throws IOException {
    try (SceneRun run = run(TimingMode.WATCHED)) {
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
    try (SceneRun run = run(TimingMode.UNWATCHED)) {
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

  @Test
  void aRowSaysWhenItsFrameWasSteppedAndWhetherItWasSeen() throws IOException {
    guide.darkness = 0.6;
    try (SceneRun run = run(TimingMode.WATCHED)) {
      stepped(run);
      drawnAfterTwoSeconds(run);
      guide.darkness = 0.4;
      stepped(run);
      drawnAfterTwoSeconds(run);
      stepped(run);
      nanos.addAndGet(250_000_000L); // The window is hidden: nothing is drawn.
      stepped(run);
      drawnAfterTwoSeconds(run);
    }
    List<HeadSample> rows = rows();
    assertThat(rows).extracting(HeadSample::t).containsExactly(0.0, 2.0, 4.0, 4.25);
    assertThat(rows).extracting(HeadSample::frameMs).containsExactly(0.0, 2000.0, 2000.0, 250.0);
    assertThat(rows).extracting(HeadSample::visible).containsExactly(false, true, false, true);
    assertThat(rows).extracting(row -> row.moment().mono()).containsExactly(7.0, 9.0, 11.0, 11.25);
    assertThat(rows).allMatch(row -> row.moment().wall() != null);
  }

  @Test
  void inAPauseTheLogsTimeStandsStillAndTheMachinesGoesOn() throws IOException {
    try (SceneRun run = run(TimingMode.WATCHED)) {
      stepped(run);
      drawnAfterTwoSeconds(run);
      guide.paused = true;
      stepped(run);
      drawnAfterTwoSeconds(run);
      stepped(run);
      nanos.addAndGet(1_000_000_000L);
      guide.paused = false;
      stepped(run);
      drawnAfterTwoSeconds(run);
    }
    List<HeadSample> rows = rows();
    assertThat(rows).extracting(HeadSample::t).containsExactly(0.0, 1.0);
    assertThat(rows).extracting(HeadSample::frameMs).containsExactly(0.0, 1000.0);
    assertThat(rows).extracting(row -> row.moment().mono()).containsExactly(7.0, 12.0);
  }

  @Test
  void anEmptyWindowDoesNotStayOpenForAFileThatIsNoScene() throws IOException {
    Path file = Files.writeString(folder.resolve("no.x3d"), "hello");
    RunSettings settings = new RunSettings(file, SelectiveController.Settings.SELECTIVE);
    List<String> told = new ArrayList<>();
    RunListener listener =
        new RunListener() {
          @Override
          public void problem(Problem problem) {
            told.add(problem.message());
          }

          @Override
          public void happened(TimelineEvent event) {
            throw new AssertionError(event);
          }

          @Override
          public void printed(String text) {
            throw new AssertionError(text);
          }
        };
    HeadTrackingSession head = HeadTrackingSession.open(settings, QUIET::problem);
    try (SceneRun run =
        new SceneRun(settings, listener, head, guide, TimingMode.WATCHED, new RunCancellation())) {
      run.awaitScene();
      assertThat(run.step()).isEmpty();
      assertThat(run.finished()).isTrue();
      assertThat(run.unreadable()).isTrue();
      assertThat(run.end(FrameTarget.LastPictures.NONE).problems()).isTrue();
    }
    assertThat(told).singleElement().asString().contains("neither XML nor VRML nor JSON");
  }

  private List<HeadSample> rows() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    List<HeadSample> rows = HeadLogReader.read(log, problems).orElseThrow().samples();
    assertThat(problems.list()).isEmpty();
    return rows;
  }

  private static final class DimGuide implements RunController {
    private double darkness;
    private boolean paused;

    @Override
    public double darkness(double seconds) {
      return paused ? 1 : darkness;
    }

    @Override
    public boolean paused() {
      return paused;
    }
  }

  private SceneRun run(TimingMode pace) throws IOException {
    log = folder.resolve("log.csv");
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Immersive'><Scene><Shape><Box/></Shape></Scene></X3D>");
    RunSettings settings =
        new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
            .lasting(OptionalDouble.of(5))
            .with(TrackerSettings.NONE, Optional.of(new HeadLogSettings(log)));
    SceneRun run =
        new SceneRun(
            settings,
            QUIET,
            HeadTrackingSession.open(settings, QUIET::problem),
            guide,
            pace,
            new RunCancellation(),
            Optional.empty(),
            new Stopwatch(nanos::get));
    run.awaitScene();
    return run;
  }

  private static double stepped(SceneRun run) {
    return run.step().orElseThrow().time();
  }

  private void drawnAfterTwoSeconds(SceneRun run) {
    nanos.addAndGet(2_000_000_000L);
    run.drawn(new FrameStatistics(1, 12));
    run.submitted();
  }
}
