package org.selectiverenderer.runtime;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.collide.MeshTrees;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Fog;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.nodes.bind.BindStacks;
import org.selectiverenderer.runtime.nodes.key.KeyDevice;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.runtime.sound.Voice;
import org.selectiverenderer.runtime.viewer.Extent;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/**
 * A running scene and its viewer, without window and GL. {@link #step} is one frame: tasks posted
 * by other threads, the viewer's motion, sensors, the event cascade with all listeners, and the
 * instance tree brought up to date; what is drawn afterwards shows all of it. With the same scene,
 * times and motion the same frames come out.
 *
 * <p>Threads: one thread steps the world and may read it between steps, in {@link #hold} when
 * others may {@link #execute} meanwhile.
 */
public final class World {
  /** Hears that the world shows another scene. */
  @FunctionalInterface
  public interface ReplaceListener {
    void replaced(World world);
  }

  private final Problems problems;
  private final Cascade cascade;
  private final Viewer viewer = new Viewer();
  private final WorldTasks tasks;
  private final Views views = new Views(this);
  private final List<ReplaceListener> replaceListeners = new ArrayList<>();
  private final KeyDevice keys = new KeyDevice();
  private final MeshTrees meshes = new MeshTrees();
  private final ConcurrentLinkedQueue<Pointer> pointed = new ConcurrentLinkedQueue<>();

  private final List<Runnable> stepListeners = new ArrayList<>();
  private double time = Double.NaN;
  private double epoch = EPOCH;
  private volatile boolean running = true;
  private Picture picture = Picture.DEFAULT;
  private RunningScene shown;

  public World(LoadedScene loaded, Problems problems) {
    this.problems = problems;
    cascade = new Cascade(problems);
    tasks = new WorldTasks(problems);
    shown = new RunningScene(this, loaded);
  }

  /** Shows another scene, from its start viewpoint; listeners hear of it. */
  public void replace(LoadedScene loaded) {
    RunningScene before = shown;
    before.close();
    shown = new RunningScene(this, loaded);
    replaceListeners.forEach(listener -> listener.replaced(this));
  }

  /** The same, if that scene is still the one shown. */
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

  /** What is in the scene; in one with layers, in the one that the user walks in. */
  public InstanceTree instances() {
    return shown.layers.active().instances;
  }

  /** Polygons of all layers in their present versions, seen or not. */
  public long shownPolygons() {
    return shown.layers.shownPolygons();
  }

  /** The meshes and images of the scene's nodes. */
  public Assets assets() {
    return shown.files.assets();
  }

  /** What rays and collisions search the meshes by; made where it is needed, for all to share. */
  public MeshTrees meshes() {
    return meshes;
  }

  public Viewer viewer() {
    return viewer;
  }

  /** Which Viewpoint, NavigationInfo, Background and Fog are bound, in the active layer. */
  public BindStacks bindables() {
    return shown.layers.active().bindables;
  }

  /** Carries events; fields are set through it. */
  public Cascade cascade() {
    return cascade;
  }

  public Problems problems() {
    return problems;
  }

  /** What is to be seen behind everything. */
  public Backdrop backdrop() {
    return shown.layers.active().backdrop().orElse(Backdrop.BLACK);
  }

  /** The fog that the bound Fog makes. */
  public Fog fog() {
    return shown.layers.active().fog();
  }

  LayerStack stack() {
    return shown.layers;
  }

  /**
   * The layers that are seen, the lowest first (X3D 4.0, 35.2): one for a scene without a LayerSet.
   */
  public List<LayerView> layers() {
    return shown.layers.views();
  }

  /**
   * A picture of that size is about to be drawn, of one eye where there are two: what the scene
   * measures by the picture or in pixels follows (X3D 4.0, clause 36). Without a picture 1024 x 768
   * are assumed. For the thread that steps.
   *
   * @param width in pixels of the desktop, above 0
   * @param height in pixels of the desktop, above 0
   * @param frustum of a display that shows another angle than the viewer's: what is seen at a
   *     distance of 1
   */
  public void seenIn(double width, double height, Optional<Extent> frustum) {
    picture = new Picture(width, height, frustum);
    shown.layers.see(picture);
  }

  /** What the scene is seen in. */
  Picture picture() {
    return picture;
  }

  /**
   * The pointing device moved, or its button went down or up. Evaluated in the next step, before
   * its events are carried. Thread-safe.
   */
  public void point(Pointer pointer) {
    pointed.add(pointer);
  }

  /** The keyboard of the scene's sensors. */
  public KeyDevice keys() {
    return keys;
  }

  /**
   * Whether a drag sensor has the pointing device, or would have it if its button went down now:
   * then dragging is not the viewer's. As of the last step.
   */
  public boolean wantsDrag() {
    return shown.layers.anyPointing(Pointing::wantsDrag);
  }

  /** Whether the scene has a drag sensor. */
  public boolean draggable() {
    return shown.layers.all().stream().anyMatch(SceneLayer::draggable);
  }

  /** Whether the pointing device is held for a drag. As of the last step. */
  public boolean dragging() {
    return shown.layers.anyPointing(Pointing::dragging);
  }

  /**
   * What the author says of what the pointing device is over: the descriptions of its sensors or
   * Anchor (X3D 4.0, 20.2.1). As of the last step.
   */
  public List<String> descriptions() {
    return shown.layers.descriptions();
  }

  /**
   * The SFTime at which the world's time is 0. X3D counts time from 1970 (X3D 4.0, 4.4.8.3), so
   * that a startTime of 0 is long past. This one is fixed, so that the same walk gives the same
   * events.
   */
  public static final double EPOCH = 1L << 30;

  /**
   * Counts from another time, for programs that set times by the clock on the wall. Before the
   * first step.
   *
   * @param seconds since 1970 at the world's time 0
   */
  public void epoch(double seconds) {
    epoch = seconds;
  }

  /** The time of the last step in seconds of the world's own time; NaN before the first. */
  public double time() {
    return time;
  }

  /** Runs a task on the stepping thread at the beginning of the next step. Thread-safe. */
  public void post(Runnable task) {
    tasks.post(task);
  }

  /**
   * Runs a task that changes the scene, so that it is done when this returns: at once when no step
   * is under way or this is the stepping thread, else when the step has ended. Should that take
   * longer than a second, since a listener waits for this very thread, the task is left to the
   * beginning of the next step. Tasks run in the order in which they came. Thread-safe.
   */
  public void execute(Runnable task) {
    tasks.execute(task, Location.of(shown.scene.url()));
  }

  /**
   * Runs a task, such as drawing, while no other thread changes the world. For the stepping thread,
   * between steps.
   */
  public void hold(Runnable task) {
    tasks.hold(task);
  }

  /** Called at the end of every step, on the stepping thread. */
  public void onStep(Runnable listener) {
    stepListeners.add(listener);
  }

  public void running(boolean run) {
    running = run;
  }

  /**
   * One frame.
   *
   * @param now the frame's time in seconds, not before the last one's
   * @param motion moves the viewer
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
    tasks.runDeferred(Location.of(shown.scene.url()));
    tasks.runPosted(); // They may show another scene.
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
  }

  private static <T> List<T> drain(Queue<T> queue) {
    List<T> drained = new ArrayList<>();
    for (T next = queue.poll(); next != null; next = queue.poll()) {
      drained.add(next);
    }
    return drained;
  }

  /** What is heard as of the last step: nothing in a scene without a Sound. */
  public List<Voice> voices() {
    return shown.voices();
  }

  /**
   * Has pictures wait for those of films. Where times are not those of a clock, what is seen must
   * not depend on how fast this machine decodes.
   */
  public void waitForFilms() {
    shown.files.waitForFilms();
  }

  /** Where the viewer can be taken. */
  public Views views() {
    return views;
  }

  /** What the pointing device said since the last frame, the last of it. */
  Optional<Pointer> latestPointer() {
    return pointed.stream().reduce((before, after) -> after);
  }
}
