package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.clock.TimingMode;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.head.TrackerRecorder;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.metrics.RunMetrics;
import org.selectiverenderer.app.operator.OperatorConsole;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.display.OperatorPage;
import org.selectiverenderer.render.display.WorldController;
import org.selectiverenderer.render.display.WorldDisplay;
import org.selectiverenderer.render.window.InputEvent;

/**
 * Shows several runs one after the other in the same windows. The windows stay open and are black
 * in between, so that a participant never sees the desktop; the head tracker stays open, too. Each
 * run is a {@link SceneRun}, so what is shown and logged is what the command {@code run} shows and
 * logs; each run loads its scene anew.
 */
public final class RunSequence implements WorldController {
  /** The source of the runs. All calls come from the render thread. */
  public interface Runs {
    /**
     * Returns the next run; empty when there are no more.
     *
     * @throws IOException ends the chain
     */
    Optional<RunRequest> next() throws IOException;

    /**
     * Reports that a run has ended and its files are closed.
     *
     * @throws IOException ends the chain
     */
    void ended(RunRequest run, RunMetrics figures) throws IOException;
  }

  private final Runs runs;
  private final SharedHeadTracker tracker;
  private final Optional<HeadsetConnection> headset;
  private final RunCancellation stop;
  private @Nullable WorldDisplay window;
  private volatile @Nullable RunRequest guided;
  private @Nullable SceneRun current;
  private @Nullable IOException failure;
  private boolean finished;
  private boolean seen;

  /**
   * @param stop ends all runs as if the windows were closed
   */
  RunSequence(
      Runs runs,
      SharedHeadTracker tracker,
      Optional<HeadsetConnection> headset,
      RunCancellation stop) {
    this.runs = runs;
    this.tracker = tracker;
    this.headset = headset;
    this.stop = stop;
  }

  /**
   * Shows all runs, in windows chosen by the settings of the first one.
   *
   * @param tracker the tracker of all runs; stays open
   * @param headset the headset if the settings ask for one; the caller closes it
   * @param message receives messages about a display that is not available as requested
   * @throws IOException when a run fails, with a one-line message
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static void show(
      Runs runs,
      SharedHeadTracker tracker,
      Optional<HeadsetConnection> headset,
      Consumer<String> message)
      throws IOException, InterruptedException {
    RunCancellation stop = new RunCancellation();
    RunSequence chain = new RunSequence(runs, tracker, headset, stop);
    Optional<RunRequest> first = runs.next();
    if (first.isEmpty()) {
      return;
    }
    try {
      chain.begin(first.get());
      WorldDisplay window =
          RunWindowFactory.screen(first.get().settings(), headset, chain, message);
      chain.window = window;
      window.run();
    } finally {
      chain.close();
      stop.ended();
    }
    if (chain.failure != null) {
      throw chain.failure;
    }
  }

  private void begin(RunRequest run) throws IOException {
    guided = run;
    RunListener listener = run.listener();
    // The windows print a display fallback once; log and journal record it for each run.
    RunSettings fitted = RunWindowFactory.fitted(run.settings(), listener::displayFallback);
    TrackerRecorder tap = new TrackerRecorder();
    HeadTrackingSession head =
        HeadTrackingSession.with(
            tracker.lend(fitted.tracker(), listener::problem, tap), tap, fitted, listener::problem);
    listener.samples().ifPresent(head::tell);
    headset.filter(HeadsetConnection::tracksEyes).ifPresent(worn -> head.eyes(worn::gaze));
    current =
        new SceneRun(
            fitted,
            listener,
            head,
            run.guide(),
            TimingMode.WATCHED,
            new RunCancellation(),
            headset);
    if (headset.isPresent()) {
      current.presented(seen);
    }
  }

  private void close() throws IOException {
    SceneRun left = current;
    current = null;
    if (left != null) {
      left.close();
    }
  }

  /** Makes the windows close before the process ends, so that all files are complete. */
  @Override
  public void opening() {
    stop.drawing();
  }

  @Override
  public Optional<World> step() {
    if (stop.asked()) {
      finished = true;
      return Optional.empty();
    }
    try {
      if (current != null && !current.finished()) {
        return current.step();
      }
      if (current != null) {
        end(current);
      } else {
        Optional<RunRequest> next = runs.next();
        finished = next.isEmpty();
        if (next.isPresent()) {
          begin(next.get());
        }
      }
    } catch (IOException e) {
      failure = e;
      finished = true;
    }
    return Optional.empty();
  }

  private void end(SceneRun run) throws IOException {
    current = null;
    RunMetrics figures;
    try (run) {
      figures = run.figures(window.info().orElse(new GlInfo("", "", ""))).pacedBy(window.timing());
    }
    if (run.unreadable()) {
      throw new IOException(
          guided.settings().scene().file() + ": nothing of the scene could be read");
    }
    runs.ended(guided, figures);
  }

  /**
   * Returns true: the frames of an exposure shall be evenly spaced, so the first one, which is
   * black, may take longer.
   */
  @Override
  public boolean readyAtOnce() {
    return true;
  }

  @Override
  public void presented(boolean now) {
    seen = now;
    if (current != null) {
      current.presented(now);
    }
  }

  @Override
  public void input(InputEvent event) {
    if (current != null) {
      current.input(event);
    }
  }

  @Override
  public void operatorInput(InputEvent event) {
    if (current != null) {
      current.operatorInput(event);
    }
  }

  /**
   * Returns whether the pointer is confined; between two runs as in the previous one, because the
   * participant may go on moving the mouse.
   */
  @Override
  public boolean pointerKept() {
    RunRequest run = guided;
    return run != null && run.guide().keepsPointer();
  }

  @Override
  public boolean closing() {
    RunRequest run = guided;
    return run == null || run.guide().closing();
  }

  @Override
  public boolean finished() {
    return finished;
  }

  @Override
  public List<String> overlay() {
    return List.of();
  }

  @Override
  public List<String> waiting() {
    return List.of();
  }

  @Override
  public double darkness() {
    return current == null ? 1 : current.darkness();
  }

  @Override
  public List<WorldSpacePanel> panels() {
    return current == null ? List.of() : current.panels();
  }

  @Override
  public Optional<HeadFixedPage> page() {
    return current == null ? Optional.empty() : current.page();
  }

  @Override
  public void drawn(FrameStatistics drawn) {
    current.drawn(drawn);
  }

  @Override
  public void submitted() {
    current.submitted();
  }

  @Override
  public OperatorPage operatorPage(int width, int height, int pictureWidth, int pictureHeight) {
    return current == null
        ? OperatorConsole.waiting(List.of())
        : current.operatorPage(width, height, pictureWidth, pictureHeight);
  }
}
