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
import org.selectiverenderer.runtime.render.WorldHost;
import org.selectiverenderer.runtime.render.WorldWindow;
import org.selectiverenderer.runtime.render.context.GlInfo;
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
  private @Nullable ViewerMotion motion;
  private @Nullable Walkthrough walk;
  private @Nullable Walking walking;
  private @Nullable IOException failure;
  private long begun;
  private @Nullable FrameSchedule frames;
  private long pathFrame;
  private boolean overlay;
  private boolean unlogged;
  private boolean finished;

  private WindowRun(RunSettings settings, RunListener listener) throws IOException {
    this.settings = settings;
    head = HeadSession.open(settings, listener);
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
    WindowRun run = new WindowRun(settings, listener);
    WorldWindow window = new WorldWindow(WindowStage.of(settings, listener::printed), run);
    try {
      window.run();
      return run.result(window);
    } finally {
      run.close();
    }
  }

  private void close() throws IOException {
    try (head;
        opening) {
      if (walk != null) {
        walk.close();
      }
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
    GlInfo gl = window.info().orElse(new GlInfo("", "", ""));
    return new RunResult(
        keeper.figures(gl, head.latency()),
        walk.problems().any(),
        window.lastPicture(),
        window.lastOperatorPicture());
  }

  @Override
  public void input(InputEvent event) {
    windowInput.accept(event);
  }

  @Override
  public Optional<World> step() {
    List<NavigationCommand> commands = controls.takeCommands();
    finished |= commands.contains(NavigationCommand.LEAVE);
    if (walk == null && !open()) {
      return Optional.empty();
    }
    for (NavigationCommand command : commands) {
      overlay ^= command == NavigationCommand.TOGGLE_OVERLAY;
      if (command == NavigationCommand.RESET_HEADING) {
        head.resetHeading();
      }
      walking.command(command);
    }
    controls.looking(!head.steering());
    if (begun == 0) {
      begun = System.nanoTime();
    }
    advance((System.nanoTime() - begun) * 1e-9);
    return Optional.of(walk.world());
  }

  /** Takes the scene over once it is read. */
  private boolean open() {
    if (!opening.done()) {
      return false;
    }
    try {
      walk = opening.await();
      walking = new Walking(walk.world(), controls);
      motion =
          head.begin(
              walk,
              settings.path().map(path -> (ViewerMotion) new PathMotion(path, 0)).orElse(walking));
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
    FrameSchedule recorded = frames;
    if (recorded == null) {
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
    if (!settings.presentation().stereo() && head.health().stale()) {
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
    if (unlogged) {
      unlogged = false;
      head.log(walk.world().time());
    }
  }

  @Override
  public OperatorPage operatorPage(int width, int height, int pictureWidth, int pictureHeight) {
    return desk.page(walk, overlayText.interval(), width, height, pictureWidth, pictureHeight);
  }

  @Override
  public void drawn(Drawn drawn) {
    overlayText.frame(drawn);
    if (walk.frames() <= 1) {
      keeper.firstFrame(walk.polygons(), drawn);
    } else {
      keeper.frame(walk.polygons(), drawn);
    }
  }
}
