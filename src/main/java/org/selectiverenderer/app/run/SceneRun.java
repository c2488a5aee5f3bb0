package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.clock.Pace;
import org.selectiverenderer.app.clock.Stopwatch;
import org.selectiverenderer.app.figures.FigureKeeper;
import org.selectiverenderer.app.figures.RunFigures;
import org.selectiverenderer.app.head.FrameMoment;
import org.selectiverenderer.app.head.HeadSession;
import org.selectiverenderer.app.headset.HeadsetLink;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.walk.Viewpoints;
import org.selectiverenderer.app.walk.Walking;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.Panel;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.show.OperatorPage;
import org.selectiverenderer.runtime.render.show.WorldHost;
import org.selectiverenderer.runtime.render.window.InputEvent;
import org.selectiverenderer.runtime.viewer.ViewerMotion;
import org.selectiverenderer.runtime.walk.Controls;
import org.selectiverenderer.runtime.walk.NavigationCommand;

/**
 * A run of a scene: everything that happens between one frame and the next, whatever the frame
 * target. The frame target calls {@link #input}, {@link #step}, {@link #drawn} and {@link
 * #submitted} for each, on one thread, until the run is {@link #finished}.
 */
final class SceneRun implements WorldHost, AutoCloseable {
  /** The darkness up to which the participant counts as seeing the picture. */
  private static final double HALF = 0.5;

  private final RunSettings settings;
  private final HeadSession head;
  private final RunGuide guide;
  private final Pace pace;
  private final RunStop stop;
  private final Controls controls;
  private final RunInput input;
  private final RunText text;
  private final FigureKeeper keeper = new FigureKeeper();
  private final Stopwatch time;
  private final SceneOpening opening;
  private final SceneSound sound;
  private final RunEyes eyes;
  private RunState state = RunState.LOADING;
  private @Nullable LiveScene scene;
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
      HeadSession head,
      RunGuide guide,
      Pace pace,
      RunStop stop) {
    this(settings, listener, head, guide, pace, stop, Optional.empty());
  }

  /** Creates a run in a headset, if there is one. */
  SceneRun(
      RunSettings settings,
      RunListener listener,
      HeadSession head,
      RunGuide guide,
      Pace pace,
      RunStop stop,
      Optional<HeadsetLink> headset) {
    this(settings, listener, head, guide, pace, stop, headset, new Stopwatch());
  }

  /** Creates a run with a given stopwatch. */
  SceneRun(
      RunSettings settings,
      RunListener listener,
      HeadSession head,
      RunGuide guide,
      Pace pace,
      RunStop stop,
      Optional<HeadsetLink> headset,
      Stopwatch time) {
    this.settings = settings;
    this.head = head;
    this.guide = guide;
    this.pace = pace;
    this.stop = stop;
    this.time = time;
    controls = new Controls(settings.motion().mouse());
    input = new RunInput(controls, guide);
    text = new RunText(settings, head, guide, headset.isPresent());
    eyes = new RunEyes(headset, guide, listener);
    sound = new SceneSound(pace.audible() && !settings.scene().muted());
    opening = new SceneOpening(settings.scene(), listener);
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
  public void started() {
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
    eyes.tell(Optional.ofNullable(scene).map(LiveScene::walk));
    // In a headset the scene begins when its user first sees the picture.
    if (state == RunState.LOADING && opening.done() && eyes.begun()) {
      open();
    }
    if (stop.asked() || commands.contains(NavigationCommand.LEAVE)) {
      state = state.then(RunState.OVER);
    }
    LiveScene live = scene;
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
      if (pace == Pace.WATCHED && walk.unreadable()) {
        unreadable = true; // Otherwise an empty window would stay open.
        state = state.then(RunState.OVER);
        return;
      }
      World world = walk.world();
      if (settings.motion().viewpoint().isPresent()) {
        Viewpoints.start(world, settings.motion().viewpoint().get());
      }
      Walking walking = new Walking(world, controls, settings.motion().collisions());
      guide.opened(walk);
      scene =
          new LiveScene(
              walk, walking, motion(walk, walking), pace.clock(settings, head.replayed()));
      pace.begin(world, settings);
      keeper.loaded();
      state = state.then(RunState.READY);
    } catch (IOException e) {
      failure = e;
      state = state.then(RunState.OVER);
    }
  }

  /**
   * Returns what moves the viewer. Where the head's position is tracked, the guide moves the body
   * and the tracker moves the head relative to it.
   */
  private ViewerMotion motion(Walkthrough walk, Walking walking) throws IOException {
    ViewerMotion moving = pace.motion(settings, walking);
    if (!eyes.worn() && !settings.tracker().placed()) {
      return guide.motion(head.begin(walk, moving, null));
    }
    boolean follows = guide.walks() && moving == walking;
    return head.begin(walk, guide.motion(moving), follows ? walking::push : null);
  }

  private void obey(NavigationCommand command, Walking walking) {
    guide.heard(command);
    switch (command) {
      case RESET_HEADING -> head.resetHeading();
      case TOGGLE_OVERLAY -> text.toggle();
      default -> walking.command(command);
    }
  }

  private void advance(LiveScene live, double elapsed) {
    boolean over = guide.over(elapsed);
    if (!paused() || live.walk().frames() == 0) {
      head.log(false); // A frame that was stepped but not drawn because the window was hidden.
      for (double frame : live.clock().due(elapsed)) {
        head.log(seen()); // One of several frames that became due during a slow picture.
        live.walk().step(frame, live.motion());
        head.stepped(FrameMoment.now(frame, time));
      }
      over |= live.clock().over(elapsed);
    }
    if (over) {
      state = state.then(RunState.OVER);
    }
  }

  @Override
  public boolean finished() {
    return state == RunState.OVER;
  }

  @Override
  public boolean closing() {
    return guide.closing();
  }

  @Override
  public void drawn(Drawn drawn) {
    if (state == RunState.READY) {
      state = state.then(RunState.SHOWN);
      if (pace.countsFromFirstPicture()) {
        time.restart(); // The time to upload the scene to the GPU does not count.
      }
    }
    text.frame(drawn);
    keeper.frame(walk().polygons(), drawn);
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
  public List<Panel> panels() {
    return guide.panels();
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
  RunFigures figures(GlInfo gl) throws IOException {
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
    RunFigures figures = figures(pictures.gl());
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
}
