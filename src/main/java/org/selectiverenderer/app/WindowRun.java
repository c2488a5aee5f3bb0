package org.selectiverenderer.app;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.navigation.Controls;
import org.selectiverenderer.runtime.navigation.NavigationCommand;
import org.selectiverenderer.runtime.navigation.PathMotion;
import org.selectiverenderer.runtime.navigation.ViewerMotion;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.OperatorPage;
import org.selectiverenderer.runtime.render.Stage;
import org.selectiverenderer.runtime.render.WorldHost;
import org.selectiverenderer.runtime.render.WorldWindow;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.context.GlShutdown;
import org.selectiverenderer.runtime.render.window.InputEvent;

/**
 * Runs a scene in a window. The window opens while the scene is being read. Its render thread steps
 * the world: by the clock on the wall while the user walks, by the frames of the path when one is
 * played, so that its time line is that of a simulation.
 */
public final class WindowRun implements WorldHost {
  private final RunSettings settings;
  private final Controls controls;
  private final WindowInput windowInput;
  private final OverlayText overlayText = new OverlayText();
  private final FigureKeeper keeper = new FigureKeeper();
  private final HeadSession head;
  private final SceneOpening opening;
  private final OperatorDesk desk;
  private final Optional<RunGuide> guide;
  private @Nullable ViewerMotion motion;
  private @Nullable Walkthrough walk;
  private @Nullable Walking walking;
  private @Nullable IOException failure;
  private long begun;
  private long last;
  private @Nullable FrameSchedule frames;
  private long pathFrame;
  private boolean overlay;
  private boolean unlogged;
  private boolean pictured;
  private boolean finished;
  private boolean opened;
  private @Nullable RunStop stop;

  /**
   * Begins to read the scene.
   *
   * @param head closed with the run
   * @param guide who leads the run; empty for the user
   */
  WindowRun(
      RunSettings settings, RunListener listener, HeadSession head, Optional<RunGuide> guide) {
    this.settings = settings;
    this.guide = guide;
    this.head = head;
    controls = new Controls(settings.mouse());
    windowInput = new WindowInput(controls);
    opening = new SceneOpening(settings, listener);
    desk = new OperatorDesk(settings, head);
  }

  /**
   * Shows the scene until the user or the settings end it.
   *
   * @throws IOException with a one-line message when the scene cannot be read
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static RunResult run(RunSettings settings, RunListener listener)
      throws IOException, InterruptedException {
    return run(settings, listener, new RunStop());
  }

  /**
   * The same, until somebody stops it.
   *
   * @param stop by which it is stopped
   * @throws IOException with a one-line message when the scene cannot be read
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static RunResult run(RunSettings settings, RunListener listener, RunStop stop)
      throws IOException, InterruptedException {
    RunSettings fitted = WindowStage.fitted(settings, listener::printed);
    fitted.describe(listener);
    Stage stage = WindowStage.of(fitted, listener::printed);
    // From here on the tracker is open and the log's files are taken.
    HeadSession head = HeadSession.open(fitted, listener);
    WindowRun run = new WindowRun(fitted, listener, head, Optional.empty());
    run.stop = stop;
    try {
      WorldWindow window = new WorldWindow(stage, run);
      window.run();
      return run.result(window);
    } finally {
      run.close();
      stop.ended();
    }
  }

  void close() throws IOException {
    try (head;
        opening) {
      if (walk != null) {
        logFrame();
        walk.close();
      }
    }
  }

  /** Logs the frame last stepped, unless that is done. */
  private void logFrame() {
    if (unlogged) {
      unlogged = false;
      head.log(walk.world().time());
    }
  }

  private RunResult result(WorldWindow window) throws IOException {
    if (failure != null) {
      throw failure;
    }
    if (walk == null) {
      walk = opening.await(); // Closed by the user before the scene was there.
    } else {
      walk.end();
    }
    return new RunResult(
        figures(window.info().orElse(new GlInfo("", "", ""))),
        walk.problems().any(),
        window.lastPicture(),
        window.lastOperatorPicture());
  }

  /** How it went so far. */
  RunFigures figures(GlInfo gl) {
    return keeper.figures(gl, head.latency());
  }

  /** What ended it, if something did. */
  Optional<IOException> failure() {
    return Optional.ofNullable(failure);
  }

  @Override
  public void input(InputEvent event) {
    windowInput.accept(event);
  }

  @Override
  public Optional<World> step() {
    RunStop asking = stop;
    if (asking != null && !opened) {
      opened = true;
      GlShutdown.before(asking::stopAndWait);
    }
    List<NavigationCommand> commands = controls.takeCommands();
    finished |=
        asking != null && asking.asked()
            || guide.isEmpty() && commands.contains(NavigationCommand.LEAVE);
    if (walk == null && !open()) {
      return Optional.empty();
    }
    commands.forEach(this::command);
    controls.looking(!head.steering());
    long now = System.nanoTime();
    if (begun == 0) {
      begun = now;
    } else if (guide.isPresent() && guide.get().paused()) {
      begun += now - last;
    }
    last = now;
    advance(seconds());
    return Optional.of(walk.world());
  }

  private void command(NavigationCommand command) {
    if (command == NavigationCommand.RESET_HEADING) {
      head.resetHeading();
    }
    if (guide.isEmpty()) {
      overlay ^= command == NavigationCommand.TOGGLE_OVERLAY;
      walking.command(command);
    }
  }

  /** Since the first frame, pauses not counted. */
  private double seconds() {
    return begun == 0 ? 0 : (last - begun) * 1e-9;
  }

  /** Takes the scene over once it is read. */
  private boolean open() {
    if (!opening.done()) {
      return false;
    }
    try {
      walk = opening.await();
      walking = new Walking(walk.world(), controls);
      guide.ifPresent(leader -> leader.opened(walk));
      ViewerMotion users =
          head.begin(
              walk,
              settings.path().map(path -> (ViewerMotion) new PathMotion(path, 0)).orElse(walking));
      motion = guide.map(leader -> leader.motion(users)).orElse(users);
      frames = settings.path().map(path -> FrameSchedule.path(settings, path)).orElse(null);
      if (settings.path().isEmpty()) {
        walk.world().epoch(System.currentTimeMillis() / 1000.0);
      }
      keeper.loaded();
      return true;
    } catch (IOException e) {
      failure = e;
      finished = true;
      return false;
    }
  }

  private void advance(double elapsed) {
    settings.duration().ifPresent(seconds -> finished |= elapsed >= seconds);
    guide.ifPresent(leader -> finished |= leader.over(elapsed));
    if (guide.isPresent() && guide.get().paused() && walk.frames() > 0) {
      return;
    }
    FrameSchedule recorded = frames;
    if (recorded == null) {
      logFrame(); // One that was stepped but, in a hidden window, not drawn.
      walk.step(elapsed, motion);
      unlogged = true;
      return;
    }
    double start = recorded.time(0);
    while (recorded.has(pathFrame) && recorded.time(pathFrame) - start <= elapsed) {
      double time = recorded.time(pathFrame++);
      walk.step(time, motion);
      head.log(time);
    }
    finished |= !recorded.has(pathFrame) && settings.duration().isEmpty();
  }

  @Override
  public boolean finished() {
    return finished;
  }

  @Override
  public List<String> overlay() {
    List<String> lines = new ArrayList<>();
    // In a display the participant would see it: there the operator's window says so.
    if (guide.isEmpty() && !settings.presentation().stereo() && head.health().stale()) {
      lines.add(OperatorDesk.alarm(settings, head.health()));
    }
    if (overlay) {
      lines.addAll(overlayText.lines(walk, settings.path().isPresent() ? "" : walking.describe()));
    }
    return lines;
  }

  @Override
  public void submitted() {
    head.submitted();
    logFrame();
  }

  @Override
  public OperatorPage operatorPage(int width, int height, int pictureWidth, int pictureHeight) {
    List<String> told = guide.map(leader -> leader.operatorLines(seconds())).orElse(List.of());
    if (walk == null || begun == 0) {
      return OperatorDesk.waiting(told);
    }
    return desk.page(
        walk, overlayText.interval(), told, width, height, pictureWidth, pictureHeight);
  }

  @Override
  public double darkness() {
    return guide.map(leader -> leader.darkness(seconds())).orElse(0.0);
  }

  @Override
  public void drawn(Drawn drawn) {
    overlayText.frame(drawn);
    if (!pictured) {
      pictured = true;
      keeper.firstFrame(walk.polygons(), drawn);
    } else {
      keeper.frame(walk.polygons(), drawn);
    }
  }
}
