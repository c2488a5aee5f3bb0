package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.study.headlog.HeadLogReader;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.HeadMotion;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator;
import org.selectiverenderer.tracker.emulator.PseudoTerminal;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** An emulated InterTrax2 on a pseudo-terminal turns the view of both eyes that is really drawn. */
@RequiresDisplay
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class TrackedRunTest {
  /**
   * A red box far ahead of a head turned by yaw 25, pitch -8 and roll 12 degrees, a green one ahead
   * of a head at yaw -40; both stand upright in that head's view.
   */
  private static final String SCENE =
      """
      <X3D version='4.0' profile='Immersive'><Scene>
      <Viewpoint position='0 0 0'/><NavigationInfo headlight='false' visibilityLimit='500'/>
      <Transform rotation='0 1 0 0.436332'><Transform rotation='1 0 0 -0.139626'>
      <Transform rotation='0 0 1 0.20944'><Transform DEF='Red' translation='0 0 -100'><Shape><Appearance>
      <Material diffuseColor='0 0 0' emissiveColor='1 0 0'/></Appearance><Box size='20 4 1'/></Shape>
      </Transform></Transform></Transform></Transform>
      <Transform rotation='0 1 0 -0.698132'><Transform DEF='Green' translation='0 0 -100'><Shape><Appearance>
      <Material diffuseColor='0 0 0' emissiveColor='0 1 0'/></Appearance><Box size='4 20 1'/></Shape>
      </Transform></Transform>
      </Scene></X3D>
      """;

  @TempDir private Path folder;

  /** Without an end: a busy machine may take long to see what a test waits for. */
  private RunSettings settings() throws IOException {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(scene, SCENE);
    DisplaySettings display =
        DisplaySettings.of(
                new DisplayConfiguration(
                    DisplayMode.SIDE_BY_SIDE,
                    new EyeGeometry(DisplayProfile.PROVIEW_50, 0.063),
                    false))
            .sized(1280, 480)
            .samples(OptionalInt.of(0));
    return new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
        .with(display)
        .with(
            new TrackerSettings(
                new TrackerSpec.InterTrax2(folder.resolve("tracker").toString()),
                TrackerOptions.NONE,
                WhenLost.FREEZE),
            Optional.of(new HeadLogSettings(folder.resolve("head.csv"))))
        .lasting(OptionalDouble.of(Double.POSITIVE_INFINITY));
  }

  /** A run on a thread of its own. */
  private record Running(FutureTask<RunResult> result, Thread thread, RunCancellation stop) {
    static Running start(RunSettings settings, RunListener listener) {
      RunCancellation stop = new RunCancellation();
      FutureTask<RunResult> result =
          new FutureTask<>(() -> SceneRunner.offscreen(settings, listener, stop));
      Thread thread = new Thread(result, "tracked-run");
      thread.start();
      return new Running(result, thread, stop);
    }

    /** Waits until what the head looks at is logged, which is written while it runs. */
    void awaitLogged(Path log, String object) throws IOException, InterruptedException {
      while (!Files.exists(log) || !Files.readString(log).contains("," + object + ",")) {
        thread.join(20);
        assertThat(thread.isAlive()).as("the run goes on").isTrue();
      }
    }

    RunResult end() throws InterruptedException, ExecutionException {
      stop.stop();
      return result.get();
    }
  }

  private static RunListener listener(CountDownLatch trouble) {
    return new RunListener() {
      @Override
      public void problem(Problem problem) {
        if (problem.severity() == Problem.Severity.ERROR) {
          trouble.countDown();
        }
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
  }

  private EmulatedInterTrax2 plugged(HeadMotion motion) throws IOException {
    assumeTrue(
        List.of(PseudoTerminal.Maker.values()).stream().anyMatch(PseudoTerminal.Maker::installed),
        "no program that makes pseudo-terminals is installed");
    return EmulatedInterTrax2.start(
        folder.resolve("tracker"), new InterTrax2Emulator.Settings(120, motion));
  }

  private List<HeadSample> log() throws IOException {
    return HeadLogReader.read(folder.resolve("head.csv"), new ProblemCollector())
        .orElseThrow()
        .samples();
  }

  /** The colour in the middle of an eye's picture, and beside it along and across. */
  private static List<Integer> cross(Screenshot shot, int centre) {
    return List.of(
        shot.rgb(centre, 240),
        shot.rgb(centre - 50, 240),
        shot.rgb(centre + 50, 240),
        shot.rgb(centre, 190),
        shot.rgb(centre, 290));
  }

  @Test
  void theDrawnViewLooksWhereTheEmulatorsHeadLooks()
      throws IOException, InterruptedException, ExecutionException {
    try (EmulatedInterTrax2 device = plugged((t, into) -> into.turn(25, -8, 12))) {
      assertThat(device.link()).isEqualTo(folder.resolve("tracker"));
      Running run = Running.start(settings(), listener(new CountDownLatch(1)));
      run.awaitLogged(folder.resolve("head.csv"), "Red");
      RunResult result = run.end();
      Screenshot shot = result.screenshot().orElseThrow();
      // The box lies level in the tilted view: its colour beside the middle, not above or below.
      for (int centre : new int[] {320, 960}) {
        assertThat(cross(shot, centre)).containsExactly(0xff0000, 0xff0000, 0xff0000, 0, 0);
      }
      List<HeadSample> log = log();
      HeadSample last = log.get(log.size() - 1);
      // The device's numbers have steps of 180 / 32768 degrees.
      assertThat(last.yaw()).isCloseTo(25, within(0.006));
      assertThat(last.pitch()).isCloseTo(-8, within(0.006));
      assertThat(last.roll()).isCloseTo(12, within(0.006));
      assertThat(last.object()).isEqualTo("Red");
      assertThat(last.distance()).isCloseTo(99.5, within(0.01));
      assertThat(last.moved()).isFalse();
      assertThat(result.figures().latency().count()).isPositive();
    }
  }

  @Test
  void pullingTheCableAndPluggingItInAgainIsSurvived()
      throws IOException, InterruptedException, ExecutionException {
    CountDownLatch trouble = new CountDownLatch(1);
    CountDownLatch pulled = new CountDownLatch(1);
    HeadMotion motion =
        (t, into) -> {
          if (pulled.getCount() > 0) {
            into.turn(25, -8, 12);
          } else {
            into.turn(-40, 0, 0);
          }
        };
    try (EmulatedInterTrax2 device = plugged(motion)) {
      Running run = Running.start(settings(), listener(trouble));
      run.awaitLogged(folder.resolve("head.csv"), "Red");
      device.unplug();
      trouble.await();
      pulled.countDown();
      device.plug();
      run.awaitLogged(folder.resolve("head.csv"), "Green");
      Screenshot shot = run.end().screenshot().orElseThrow();
      for (int centre : new int[] {320, 960}) {
        assertThat(cross(shot, centre).get(0)).isEqualTo(0x00ff00);
      }
      assertThat(log().stream().map(HeadSample::object).distinct()).contains("Red", "Green");
    }
  }
}
