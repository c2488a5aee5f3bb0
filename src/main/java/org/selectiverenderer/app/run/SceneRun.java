package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.clock.Stopwatch;
import org.selectiverenderer.app.clock.TimingMode;
import org.selectiverenderer.app.head.FrameTimestamp;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.metrics.RunMetrics;
import org.selectiverenderer.app.metrics.RunMetricsCollector;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.browser.sound.AudioPlayer;
import org.selectiverenderer.browser.sound.SoundDeviceLine;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.display.OperatorPage;
import org.selectiverenderer.render.display.WorldController;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.walkthrough.NavigationController;
import org.selectiverenderer.walkthrough.ViewpointFinder;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * A run of a scene: everything that happens between one frame and the next, whatever the frame
 * target. The frame target calls {@link #input}, {@link #step}, {@link #drawn} and {@link
 * #submitted} for each, on one thread, until the run is {@link #finished}.
 */
final class SceneRun implements WorldController, AutoCloseable {
  /** The darkness up to which the participant counts as seeing the picture. */
  private static final double HALF = 0.5;

  private final RunSettings settings;
  private final HeadTrackingSession head;
  private final RunController guide;
  private final TimingMode pace;
  private final RunCancellation stop;
  private final KeyboardMouseControls controls;
  private final InputDispatcher input;
  private final RunStatusFormatter text;
  private final RunMetricsCollector keeper = new RunMetricsCollector();
  private final Stopwatch time;
  private final BackgroundSceneLoader opening;
  private final SoundOutput sound;
  private final HeadsetRunState eyes;
  private final RunListener listener;
  private State state = State.LOADING;
  private @Nullable RunningSceneState scene;
  private @Nullable IOException failure;
  private boolean unreadable;

  /**
   * Creates the run and starts to load its scene in the background.
   *
   * @param head closed with the run
   * @param stop by which other code ends the run
   */
  SceneRun(
      RunSettings settings,
      RunListener listener,
      HeadTrackingSession head,
      RunController guide,
      TimingMode pace,
      RunCancellation stop) {
    this(settings, listener, head, guide, pace, stop, Optional.empty());
  }

  /** Creates a run in a headset, if there is one. */
  SceneRun(
      RunSettings settings,
      RunListener listener,
      HeadTrackingSession head,
      RunController guide,
      TimingMode pace,
      RunCancellation stop,
      Optional<HeadsetConnection> headset) {
    this(settings, listener, head, guide, pace, stop, headset, new Stopwatch());
  }

  /** Creates a run with a given stopwatch. */
  SceneRun(
      RunSettings settings,
      RunListener listener,
      HeadTrackingSession head,
      RunController guide,
      TimingMode pace,
      RunCancellation stop,
      Optional<HeadsetConnection> headset,
      Stopwatch time) {
    this.settings = settings;
    this.listener = listener;
    this.head = head;
    this.guide = guide;
    this.pace = pace;
    this.stop = stop;
    this.time = time;
    controls = new KeyboardMouseControls(settings.motion().mouse());
    input = new InputDispatcher(controls, guide);
    text = new RunStatusFormatter(settings, head, guide, headset.isPresent());
    eyes = new HeadsetRunState(headset, guide, listener);
    sound = new SoundOutput(pace.audible() && !settings.scene().muted());
    opening = new BackgroundSceneLoader(settings.scene(), listener);
  }

  /**
   * Waits until the scene is loaded.
   *
   * @throws IOException when the scene cannot be read
   */
  void awaitScene() throws IOException {
    opening.await();
  }

  @Override
  public void opening() {
    stop.drawing();
  }

  @Override
  public void input(InputEvent event) {
    input.participant(event, Optional.ofNullable(scene).map(live -> live.walk().world()));
  }

  @Override
  public void operatorInput(InputEvent event) {
    input.operator(event);
  }

  @Override
  public boolean pointerKept() {
    return guide.keepsPointer();
  }

  @Override
  public void presented(boolean seen) {
    eyes.presented(seen);
  }

  /** Returns whether the run is paused: by its guide, or because nobody wears the headset. */
  private boolean paused() {
    return guide.paused() || eyes.closed();
  }

  @Override
  public Optional<World> step() {
    List<NavigationCommand> commands =
        Stream.concat(
                controls.takeCommands().stream().filter(guide::hears),
                eyes.straightened() ? Stream.of(NavigationCommand.RESET_HEADING) : Stream.empty())
            .toList();
    eyes.tell(Optional.ofNullable(scene).map(RunningSceneState::walk));
    // In a headset the scene begins when its user first sees the picture.
    if (state == State.LOADING && opening.done() && eyes.begun()) {
      open();
    }
    if (stop.asked() || commands.contains(NavigationCommand.LEAVE)) {
      state = state.then(State.OVER);
    }
    RunningSceneState live = scene;
    if (live == null) {
      return Optional.empty();
    }
    commands.forEach(command -> obey(command, live.walking()));
    controls.looking(!head.steering());
    eyes.hands(controls, live.walk().world(), paused());
    time.tick(paused());
    advance(live, time.seconds());
    sound.hear(live.walk().world(), paused());
    input.decided(live.walk().world());
    return Optional.of(live.walk().world());
  }

  /** Takes over the loaded scene. */
  private void open() {
    try {
      Walkthrough walk = opening.await();
      if (pace == TimingMode.WATCHED && walk.unreadable()) {
        unreadable = true; // Otherwise an empty window would stay open.
        state = state.then(State.OVER);
        return;
      }
      World world = walk.world();
      if (settings.motion().viewpoint().isPresent()) {
        ViewpointFinder.start(world, settings.motion().viewpoint().get());
      }
      NavigationController walking =
          new NavigationController(world, controls, settings.motion().collisions());
      guide.opened(walk);
      scene =
          new RunningSceneState(
              walk, walking, motion(walk, walking), pace.clock(settings, head.replayed()));
      pace.begin(world, settings);
      keeper.loaded();
      state = state.then(State.READY);
    } catch (IOException e) {
      failure = e;
      state = state.then(State.OVER);
    }
  }

  /**
   * Returns what moves the viewer. Where the head's position is tracked, the guide moves the body
   * and the tracker moves the head relative to it.
   */
  private ViewerMotion motion(Walkthrough walk, NavigationController walking) throws IOException {
    ViewerMotion moving = pace.motion(settings, walking);
    if (!eyes.worn() && !settings.tracker().placed()) {
      return guide.motion(head.begin(walk, moving, null));
    }
    boolean follows = guide.walks() && moving == walking;
    return head.begin(walk, guide.motion(moving), follows ? walking::push : null);
  }

  private void obey(NavigationCommand command, NavigationController walking) {
    guide.heard(command);
    switch (command) {
      case RESET_HEADING -> head.resetHeading();
      case TOGGLE_OVERLAY -> text.toggle();
      default -> walking.command(command);
    }
  }

  private void advance(RunningSceneState live, double elapsed) {
    guide.tracked(text.alarm());
    boolean over = guide.over(elapsed);
    if (!paused() || live.walk().frames() == 0) {
      head.log(false); // A frame that was stepped but not drawn because the window was hidden.
      for (double frame : live.clock().due(elapsed)) {
        head.log(seen()); // One of several frames that became due during a slow picture.
        live.walk().step(frame, live.motion());
        listener.stepped(frame, live.walk().polygons());
        head.stepped(FrameTimestamp.now(frame, time));
      }
      over |= live.clock().over(elapsed);
    }
    if (over) {
      state = state.then(State.OVER);
    }
  }

  @Override
  public boolean finished() {
    return state == State.OVER;
  }

  @Override
  public boolean closing() {
    return guide.closing();
  }

  @Override
  public void drawn(FrameStatistics drawn) {
    if (state == State.READY) {
      state = state.then(State.SHOWN);
      if (pace.countsFromFirstPicture()) {
        time.restart(); // The time to upload the scene to the GPU does not count.
      }
    }
    text.frame(drawn);
    keeper.frame(walk().polygons(), drawn);
    walk().budget().ifPresent(budget -> budget.drawn(System.nanoTime() * 1e-9));
  }

  @Override
  public void submitted() {
    head.submitted();
    head.log(seen());
  }

  /** Returns whether the participant sees what is drawn. */
  private boolean seen() {
    return !eyes.closed() && guide.darkness(time.seconds()) <= HALF;
  }

  @Override
  public double darkness() {
    return guide.darkness(time.seconds());
  }

  @Override
  public List<WorldSpacePanel> panels() {
    return guide.panels();
  }

  @Override
  public Optional<HeadFixedPage> page() {
    return guide.page();
  }

  @Override
  public List<String> overlay() {
    return text.overlay(scene);
  }

  @Override
  public OperatorPage operatorPage(int width, int height, int pictureWidth, int pictureHeight) {
    List<String> told = guide.operatorLines(time.seconds());
    return text.operatorPage(
        Optional.ofNullable(scene), told, width, height, pictureWidth, pictureHeight);
  }

  private Walkthrough walk() {
    return scene.walk();
  }

  /**
   * Returns whether the run ended because nothing of the scene could be read; that has been
   * reported.
   */
  boolean unreadable() {
    return unreadable;
  }

  /**
   * Returns the measurements of the run so far.
   *
   * @throws IOException the failure that ended the run, if one did
   */
  RunMetrics figures(GlInfo gl) throws IOException {
    if (failure != null) {
      throw failure;
    }
    return keeper.figures(
        gl, settings.display().shading(), head.latency(), head.longestSilence(), eyes.figures());
  }

  /**
   * Ends the walkthrough and returns the result of the run.
   *
   * @throws IOException the failure that ended the run, if one did
   */
  RunResult end(FrameTarget.LastPictures pictures) throws IOException {
    RunMetrics figures = figures(pictures.gl());
    // The user may have closed the window before the scene was there.
    Walkthrough walk = opening.await();
    walk.end();
    return new RunResult(figures, walk.problems().any(), pictures.scene(), pictures.operator());
  }

  @Override
  public void close() throws IOException {
    try (head;
        opening;
        sound) {
      head.log(false); // The last one was stepped, and the window closed before it was shown.
    }
  }

  /** The state of a run; states only advance. */
  private enum State {
    /** The scene is being loaded; there is nothing to show. */
    LOADING,
    /** The scene is loaded and is stepped; no picture of it has been shown. */
    READY,
    /** Pictures are shown. */
    SHOWN,
    /** The last frame has been stepped, or there will be none. */
    OVER;

    private static final Map<State, Set<State>> NEXT =
        Map.of(
            LOADING, Set.of(READY, OVER),
            READY, Set.of(SHOWN, OVER),
            SHOWN, Set.of(OVER),
            OVER, Set.of(OVER)); // A run may be ended by several causes at once.

    /**
     * Checks a transition and returns the next state.
     *
     * @throws IllegalStateException if it cannot follow this one
     */
    State then(State next) {
      if (!NEXT.getOrDefault(this, Set.of()).contains(next)) {
        throw new IllegalStateException(this + " is not followed by " + next);
      }
      return next;
    }
  }

  /** Plays the sounds of a real-time run. A missing sound device is reported once. */
  private static final class SoundOutput implements AutoCloseable {
    private final AudioPlayer speaker = new AudioPlayer(SoundDeviceLine::open);
    private final boolean audible;

    /**
     * @param audible whether sounds are played at all
     */
    SoundOutput(boolean audible) {
      this.audible = audible;
    }

    /**
     * Plays the sounds that are active after a step.
     *
     * @param silent whether the run is paused
     */
    void hear(World world, boolean silent) {
      if (!audible) {
        return;
      }
      speaker.play(silent ? List.of() : world.voices());
      speaker
          .fault()
          .ifPresent(
              reason ->
                  world
                      .problems()
                      .info(
                          SourceLocation.of(world.scene().url()),
                          "the sounds of the scene cannot be played: %s; use --mute to run without"
                              .formatted(reason)));
    }

    @Override
    public void close() {
      speaker.close();
    }
  }
}
