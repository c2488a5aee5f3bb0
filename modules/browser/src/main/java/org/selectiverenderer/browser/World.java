package org.selectiverenderer.browser;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Fog;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.nodes.bindable.BindingStacks;
import org.selectiverenderer.browser.nodes.keyboard.KeyDevice;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.script.ScriptTimeBudget;
import org.selectiverenderer.browser.sound.Voice;
import org.selectiverenderer.browser.viewer.EyeFrame;
import org.selectiverenderer.browser.viewer.OrthographicExtent;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;

/**
 * A running scene and its viewer, without a window and without GL. One call of {@link #step} is one
 * frame: it runs the tasks that other threads have posted, moves the viewer, updates the sensors,
 * runs the event cascade with all listeners, and brings the instance tree up to date; a picture
 * drawn afterwards shows all of it. The same scene, times and motion always give the same frames.
 *
 * <p>Threads: one thread steps the world and may read it between steps. If other threads may call
 * {@link #execute} meanwhile, it must read inside {@link #hold}.
 */
public final class World {
  private Optional<Boolean> headlight = Optional.empty();

  /** Is called when the world shows another scene. */
  @FunctionalInterface
  public interface ReplaceListener {
    void replaced(World world);
  }

  private final ProblemCollector problems;
  private final EventCascade cascade;
  private final Viewer viewer = new Viewer();
  private final WorldTaskQueue tasks;
  private final ViewpointNavigator views = new ViewpointNavigator(this);
  private final List<ReplaceListener> replaceListeners = new ArrayList<>();
  private final KeyDevice keys = new KeyDevice();
  private final ScriptTimeBudget scriptTime = new ScriptTimeBudget();
  private final MeshBvhCache meshes = new MeshBvhCache();
  private final ConcurrentLinkedQueue<PointingDeviceState> pointed = new ConcurrentLinkedQueue<>();

  private final List<Runnable> stepListeners = new ArrayList<>();
  private final List<Runnable> decisions = new ArrayList<>();
  private double time = Double.NaN;
  private double epoch = EPOCH;
  private volatile boolean running = true;
  private DisplayMetrics picture = DisplayMetrics.DEFAULT;
  private List<EyeFrame> eyes = List.of();
  private RunningScene shown;

  public World(LoadedScene loaded, ProblemCollector problems) {
    this.problems = problems;
    cascade = new EventCascade(problems);
    tasks = new WorldTaskQueue(problems);
    shown = new RunningScene(this, loaded);
  }

  /** Shows another scene from its start viewpoint and calls the replace listeners. */
  public void replace(LoadedScene loaded) {
    RunningScene before = shown;
    before.close();
    shown = new RunningScene(this, loaded);
    replaceListeners.forEach(listener -> listener.replaced(this));
  }

  /** Shows another scene, but only if {@code before} is still the scene shown. */
  void replace(RunningScene before, LoadedScene loaded) {
    if (shown == before) {
      replace(loaded);
    }
  }

  public void onReplace(ReplaceListener listener) {
    replaceListeners.add(listener);
  }

  public Scene scene() {
    return shown.scene;
  }

  /** Returns the instance tree of the scene, or of the active layer in a scene with layers. */
  public InstanceTree instances() {
    return shown.layers.active().instances;
  }

  /**
   * Returns the number of polygons of all layers with the versions now shown, inside the view or
   * not.
   */
  public long shownPolygons() {
    return shown.layers.shownPolygons();
  }

  /** Returns the meshes and images of the scene's nodes. */
  public AssetProvider assets() {
    return shown.files.assets();
  }

  /**
   * Returns the BVHs of the meshes, which ray casting and collisions share; each is built when
   * first needed.
   */
  public MeshBvhCache meshes() {
    return meshes;
  }

  public Viewer viewer() {
    return viewer;
  }

  /**
   * Returns the binding stacks of the active layer: its bound Viewpoint, NavigationInfo, Background
   * and Fog.
   */
  public BindingStacks bindables() {
    return shown.layers.active().bindables;
  }

  /** Returns the event cascade, through which fields are set. */
  public EventCascade cascade() {
    return cascade;
  }

  public ProblemCollector problems() {
    return problems;
  }

  /** Returns the bound background of the active layer. */
  public Background backdrop() {
    return shown.layers.active().backdrop().orElse(Background.BLACK);
  }

  /** Returns the fog of the bound Fog node. */
  public Fog fog() {
    return shown.layers.active().fog();
  }

  LayerStack stack() {
    return shown.layers;
  }

  /**
   * Returns the visible layers, the lowest first (X3D 4.0, 35.2); one layer for a scene without a
   * LayerSet.
   */
  public List<LayerView> layers() {
    return shown.layers.views();
  }

  /**
   * Announces that a picture of a given size is about to be drawn (in stereo: one eye's picture),
   * so that layout nodes, which are measured in pixels or in fractions of the picture (X3D 4.0,
   * clause 36), adapt to it. Until the first call 1024 x 768 is assumed. To be called by the
   * stepping thread.
   *
   * @param width the picture's width in desktop pixels, above 0
   * @param height the picture's height in desktop pixels, above 0
   * @param frustum the cross-section of the display's view frustum at distance 1, for displays
   *     whose viewing angle differs from the viewer's
   */
  public void seenIn(double width, double height, Optional<OrthographicExtent> frustum) {
    picture = new DisplayMetrics(width, height, frustum);
    eyes = List.of();
    shown.layers.see(picture);
  }

  /**
   * Announces likewise that pictures of several eyes are about to be drawn.
   *
   * @param views the views of the eyes, of which the first one's size counts
   * @param frustum the cross-section of the first one's frustum at distance 1, about its axis
   */
  public void seenBy(List<EyeFrame> views, Optional<OrthographicExtent> frustum) {
    seenIn(views.get(0).width(), views.get(0).height(), frustum);
    eyes = List.copyOf(views);
  }

  /** Returns the views of the eyes of a stereo display; empty if there is one eye, the viewer's. */
  public List<EyeFrame> eyes() {
    return eyes;
  }

  /** Returns the width of the picture, of one eye in stereo, in desktop pixels. */
  public double pictureWidth() {
    return picture.width();
  }

  /** Returns the height of the picture, of one eye in stereo, in desktop pixels. */
  public double pictureHeight() {
    return picture.height();
  }

  /** Returns the time that scripts may take, of this scene and of those that replace it. */
  ScriptTimeBudget scriptTime() {
    return scriptTime;
  }

  /** Returns the size of the picture in which the scene is seen. */
  DisplayMetrics picture() {
    return picture;
  }

  /**
   * Reports that the pointing device moved or that its button went down or up. The next step
   * evaluates it before it delivers events. Thread-safe.
   */
  public void point(PointingDeviceState pointer) {
    pointed.add(pointer);
  }

  /** Returns the keyboard that the scene's key device sensors listen to. */
  public KeyDevice keys() {
    return keys;
  }

  /**
   * Returns whether a drag sensor has grabbed the pointing device, or would grab it if the button
   * went down now; then a drag must not move the viewer. As of the last step.
   */
  public boolean wantsDrag() {
    return shown.layers.anyPointing(PointingDeviceHandler::wantsDrag);
  }

  /** Returns whether the scene has a drag sensor. */
  public boolean draggable() {
    return shown.layers.all().stream().anyMatch(SceneLayer::draggable);
  }

  /** Returns whether a drag sensor has grabbed the pointing device, as of the last step. */
  public boolean dragging() {
    return shown.layers.anyPointing(PointingDeviceHandler::dragging);
  }

  /**
   * Returns the descriptions of the sensors or the Anchor under the pointing device (X3D 4.0,
   * 20.2.1), as of the last step.
   */
  public List<String> descriptions() {
    return shown.layers.descriptions();
  }

  /**
   * The SFTime at which the world's time is 0. X3D counts time from 1970 (X3D 4.0, 4.4.8.3), so
   * that a startTime of 0 is long past. This value is a constant, so that the same walk always
   * gives the same events.
   */
  public static final double EPOCH = 1L << 30;

  /**
   * Sets another origin of time, for programs that work with wall-clock time. To be called before
   * the first step.
   *
   * @param seconds since 1970 at the world's time 0
   */
  public void epoch(double seconds) {
    epoch = seconds;
  }

  /** Returns the time of the last step in seconds of world time; NaN before the first step. */
  public double time() {
    return time;
  }

  /** Runs a task on the stepping thread at the beginning of the next step. Thread-safe. */
  public void post(Runnable task) {
    tasks.post(task);
  }

  /**
   * Runs a task that changes the scene and returns when it is done. The task runs at once if no
   * step is under way or if the caller is the stepping thread, else when the step has ended. If
   * that takes longer than a second, because a listener waits for the calling thread, the task is
   * deferred to the beginning of the next step. Tasks run in the order of their calls. Thread-safe.
   */
  public void execute(Runnable task) {
    tasks.execute(task, () -> SourceLocation.of(shown.scene.url()));
  }

  /**
   * Runs a task, such as drawing, while no other thread changes the world. For the stepping thread,
   * between steps.
   */
  public void hold(Runnable task) {
    tasks.hold(task);
  }

  /** Adds a listener that is called at the end of every step, on the stepping thread. */
  public void onStep(Runnable listener) {
    stepListeners.add(listener);
  }

  /**
   * Adds a decision that is made in every step when the viewer has moved and all events have
   * arrived; what it changes in the scene takes effect in the same step. Called on the stepping
   * thread.
   */
  public void onSettled(Runnable decision) {
    decisions.add(decision);
  }

  public void running(boolean run) {
    running = run;
  }

  /**
   * Runs one frame.
   *
   * @param now the frame's time in seconds, not less than that of the last frame
   * @param motion the motion that moves the viewer
   */
  public void step(double now, ViewerMotion motion) {
    hold(
        () -> {
          frame(now, motion);
          stepListeners.forEach(Runnable::run);
        });
  }

  private void frame(double now, ViewerMotion motion) {
    double dt = Double.isNaN(time) ? 0 : Math.max(0, now - time);
    time = now;
    cascade.at(epoch + now);
    shown.frameNodes();
    shown.scripts.start();
    tasks.runDeferred(SourceLocation.of(shown.scene.url()));
    tasks.runPosted(); // A task may show another scene.
    shown.settle();
    if (!running) {
      return;
    }
    LayerStack layers = shown.layers;
    layers.active().follower.follow();
    layers.lead();
    motion.move(viewer, now, dt);
    layers.look(cascade);
    keys.frame(cascade);
    layers.point(drain(pointed), cascade);
    shown.frameNodes();
    shown.scripts.prepare(epoch + now, viewer.position());
    layers.sense(epoch + now, cascade);
    shown.settle();
    if (!decisions.isEmpty()) {
      decisions.forEach(Runnable::run);
      shown.settle();
    }
  }

  private static <T> List<T> drain(Queue<T> queue) {
    List<T> drained = new ArrayList<>();
    for (T next = queue.poll(); next != null; next = queue.poll()) {
      drained.add(next);
    }
    return drained;
  }

  /**
   * Returns the voices that are audible as of the last step; none in a scene without a Sound node.
   */
  public List<Voice> voices() {
    return shown.voices();
  }

  /**
   * Makes drawing wait until the due movie frames are decoded. Where frame times do not come from a
   * clock, the picture must not depend on how fast this machine decodes.
   */
  public void waitForFilms() {
    shown.files.waitForFilms();
  }

  /** Returns the navigator that moves the viewer to viewpoints and shapes. */
  public ViewpointNavigator views() {
    return views;
  }

  /** Returns the last state of the pointing device since the last frame, if there was one. */
  Optional<PointingDeviceState> latestPointer() {
    return pointed.stream().reduce((before, after) -> after);
  }

  /** Turns the viewer's headlight on or off, whatever the scene's NavigationInfo says. */
  public void headlight(boolean on) {
    headlight = Optional.of(on);
  }

  /**
   * Returns whether the headlight is on by {@link #headlight(boolean)}; empty where it was not
   * called.
   */
  public Optional<Boolean> headlight() {
    return headlight;
  }
}
