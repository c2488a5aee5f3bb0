package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.clock.Stopwatch;
import org.selectiverenderer.app.clock.TimingMode;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.PointingDeviceState;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** What the user does is the scene's where the scene wants it, else it moves the viewer. */
class SceneInputTest {
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

  private static final String FLY = "<NavigationInfo type='\"FLY\"'/>";
  private static final String PLATE = "<Shape><Rectangle2D size='2 2'/></Shape>";

  @TempDir private Path folder;
  private final AtomicLong nanos = new AtomicLong();

  private SceneRun run(String nodes) throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Full'><Scene>" + FLY + nodes + "</Scene></X3D>");
    RunSettings settings =
        new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
            .lasting(OptionalDouble.of(1000));
    SceneRun run =
        new SceneRun(
            settings,
            QUIET,
            HeadTrackingSession.open(settings, QUIET::problem),
            RunController.USER,
            TimingMode.WATCHED,
            new RunCancellation(),
            Optional.empty(),
            new Stopwatch(nanos::get));
    run.awaitScene();
    step(run);
    return run;
  }

  private World step(SceneRun run) {
    nanos.addAndGet(100_000_000L);
    return run.step().orElseThrow();
  }

  private static void point(SceneRun run, World world, double right, boolean pressed) {
    run.input(new InputEvent.MotionInput(0, 0, (int) (100 * right), 0));
    world.point(new PointingDeviceState(Optional.of(new Vector3d(right, 0, -1)), pressed));
  }

  private static void button(SceneRun run, boolean pressed) {
    run.input(new InputEvent.ButtonInput(1, pressed, 0, 0));
  }

  private static boolean looksAhead(World world) {
    return world.viewer().orientation().equals(new Quaterniond(), 1e-9);
  }

  private Quaterniond afterADrag(String nodes, boolean hovered) throws IOException {
    try (SceneRun run = run(nodes)) {
      World world = step(run);
      if (hovered) {
        point(run, world, 0, false);
        step(run);
      }
      button(run, true);
      point(run, world, 0, true);
      step(run);
      point(run, world, 0.5, true);
      step(run);
      return new Quaterniond(world.viewer().orientation());
    }
  }

  @Test
  void draggingOnADragSensorDoesNotTurnTheViewer() throws IOException {
    Quaterniond straight = new Quaterniond();
    assertThat(afterADrag("<PlaneSensor/>" + PLATE, true).equals(straight, 1e-9)).isTrue();
    assertThat(afterADrag("<PlaneSensor/>" + PLATE, false).equals(straight, 1e-9)).isTrue();
    assertThat(afterADrag("<TouchSensor/>" + PLATE, true).equals(straight, 1e-9)).isFalse();
    assertThat(afterADrag("<PlaneSensor enabled='false'/>" + PLATE, true).equals(straight, 1e-9))
        .isFalse();
  }

  @Test
  void aWholeDragBetweenTwoFramesDoesNotTurnTheViewerEither() throws IOException {
    for (boolean sensed : new boolean[] {true, false}) {
      try (SceneRun run = run("<PlaneSensor enabled='" + sensed + "'/>" + PLATE)) {
        World world = step(run);
        point(run, world, 0, false);
        button(run, true);
        world.point(new PointingDeviceState(Optional.of(new Vector3d(0, 0, -1)), true));
        point(run, world, 0.5, true);
        step(run);
        step(run);
        assertThat(looksAhead(world)).isEqualTo(sensed);
      }
    }
  }

  @Test
  void walkingIsNotEndedByAPointerThatPassesOverADragSensor() throws IOException {
    try (SceneRun run = run("<PlaneSensor/>" + PLATE)) {
      World world = step(run);
      world.point(new PointingDeviceState(Optional.of(new Vector3d(5, 0, -1)), false));
      step(run);
      button(run, true);
      world.point(new PointingDeviceState(Optional.of(new Vector3d(5, 0, -1)), true));
      for (int i = 0; i < 5; i++) {
        step(run);
      }
      double before = world.viewer().position().z();
      world.point(new PointingDeviceState(Optional.of(new Vector3d(0, 0, -1)), true));
      step(run);
      step(run);
      assertThat(world.viewer().position().z()).isLessThan(before - 0.15);
      assertThat(looksAhead(world)).isTrue();
    }
  }

  private double wayAfterKeyW(String nodes) throws IOException {
    try (SceneRun run = run(nodes)) {
      World world = step(run);
      run.input(new InputEvent.KeyInput(KeyboardKey.W, true, "w"));
      step(run);
      step(run);
      return 10 - world.viewer().position().z();
    }
  }

  @Test
  void keysThatAKeySensorListensToMoveNothing() throws IOException {
    String heard =
        "<StringSensor DEF='S' enabled='false'/><KeySensor DEF='K'/>"
            + "<WorldInfo DEF='W'/><ROUTE fromNode='K' fromField='%s' toNode='W' toField='title'/>";
    assertThat(wayAfterKeyW(heard.formatted("keyPress"))).isZero();
    assertThat(wayAfterKeyW("<StringSensor/>")).isZero();
    assertThat(wayAfterKeyW("<KeySensor/>")).isGreaterThan(0.1);
    assertThat(wayAfterKeyW("")).isGreaterThan(0.1);
  }

  @Test
  void functionKeysWorkWhoeverListens() throws IOException {
    try (SceneRun run =
        run(
            "<KeySensor DEF='K'/><IntegerTrigger DEF='T'/>"
                + "<ROUTE fromNode='K' fromField='actionKeyPress' toNode='T' toField='integerKey'/>")) {
      World world = step(run);
      run.input(new InputEvent.KeyInput(KeyboardKey.F1, true));
      run.drawn(new FrameStatistics(0, 0));
      step(run);
      assertThat(run.overlay()).isNotEmpty();
      assertThat(world.scene().find("T").orElseThrow().integer("integerKey")).isEqualTo(1);
    }
  }

  @Test
  void aKeyThatIsDownWhenTheWindowLosesTheKeyboardGoesUp() throws IOException {
    try (SceneRun run = run("<KeySensor DEF='K'/>")) {
      run.input(new InputEvent.KeyInput(KeyboardKey.W, true, "w"));
      World world = step(run);
      run.input(new InputEvent.FocusLost());
      step(run);
      assertThat(world.scene().find("K").orElseThrow().value("keyRelease")).isEqualTo("w");
    }
  }

  @Test
  void whatIsPointedAtIsDescribed() throws IOException {
    try (SceneRun run = run("<TouchSensor description='opens the door'/>" + PLATE)) {
      World world = step(run);
      assertThat(run.overlay()).isEmpty();
      point(run, world, 0, false);
      step(run);
      assertThat(run.overlay()).containsExactly("opens the door");
    }
  }
}
