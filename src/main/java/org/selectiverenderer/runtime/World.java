package org.selectiverenderer.runtime;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.BackdropReader;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.navigation.Viewer;
import org.selectiverenderer.runtime.navigation.ViewerMotion;
import org.selectiverenderer.runtime.nodes.BindStacks;
import org.selectiverenderer.runtime.nodes.FrameNode;
import org.selectiverenderer.runtime.nodes.GroupingNode;
import org.selectiverenderer.runtime.scene.ApplicationCode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * A running scene and its viewer, without window and GL. {@link #step} is one frame: tasks posted
 * by other threads, the viewer's motion, sensors, the event cascade with all listeners, and the
 * instance tree brought up to date; what is drawn afterwards shows all of it. With the same scene,
 * times and motion the same frames come out.
 *
 * <p>Threads: one thread steps the world and may touch it between steps; others {@link #post}.
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
  private final ConcurrentLinkedQueue<Runnable> posted = new ConcurrentLinkedQueue<>();
  private final ConcurrentLinkedQueue<Runnable> deferred = new ConcurrentLinkedQueue<>();
  private final List<ReplaceListener> replaceListeners = new ArrayList<>();
  private Scene scene;
  private Assets assets;
  private InstanceTree instances;
  private BindStacks bindables;
  private ViewpointFollower follower;
  private List<FrameNode> frameNodes = List.of();
  private long frameNodesOf;
  private final ReentrantLock lock = new ReentrantLock();
  private final List<Runnable> stepListeners = new ArrayList<>();
  private double time = Double.NaN;
  private volatile boolean running = true;

  public World(LoadedScene loaded, Problems problems) {
    this.problems = problems;
    cascade = new Cascade(problems);
    place(loaded);
  }

  /** Shows another scene, from its start viewpoint; listeners hear of it. */
  public void replace(LoadedScene loaded) {
    place(loaded);
    replaceListeners.forEach(listener -> listener.replaced(this));
  }

  private void place(LoadedScene loaded) {
    scene = loaded.scene();
    assets = loaded.assets();
    instances = new InstanceTree((GroupingNode) scene.root(), loaded.assets());
    bindables = new BindStacks(scene.root(), cascade);
    follower = new ViewpointFollower(instances, bindables, viewer);
    frameNodesOf = 0;
  }

  public void onReplace(ReplaceListener listener) {
    replaceListeners.add(listener);
  }

  public Scene scene() {
    return scene;
  }

  public InstanceTree instances() {
    return instances;
  }

  /** The meshes and images of the scene's nodes. */
  public Assets assets() {
    return assets;
  }

  public Viewer viewer() {
    return viewer;
  }

  /** Which Viewpoint, NavigationInfo, Background and Fog are bound. */
  public BindStacks bindables() {
    return bindables;
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
    return bindables.bound("X3DBackgroundNode").map(BackdropReader::read).orElse(Backdrop.BLACK);
  }

  /** The time of the last step in seconds; NaN before the first. */
  public double time() {
    return time;
  }

  /** Runs a task on the stepping thread at the beginning of the next step. Thread-safe. */
  public void post(Runnable task) {
    posted.add(task);
  }

  /**
   * Runs a task that changes the scene, so that it is done when this returns: at once when no step
   * is under way or this is the stepping thread, else when the step has ended. Should that take
   * longer than a second, since a listener waits for this very thread, the task is left to the
   * beginning of the next step. Tasks run in the order in which they came. Thread-safe.
   */
  public void execute(Runnable task) {
    if (lock.isHeldByCurrentThread()) {
      task.run();
    } else if (lockWithinASecond()) {
      try {
        runDeferred();
        task.run();
      } finally {
        lock.unlock();
      }
    } else {
      deferred.add(task);
    }
  }

  private boolean lockWithinASecond() {
    try {
      return lock.tryLock() || lock.tryLock(1, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Tasks whose callers are gone: what they throw can only be reported. */
  private void runDeferred() {
    for (Runnable task = deferred.poll(); task != null; task = deferred.poll()) {
      ApplicationCode.call(problems, Location.of(scene.url()), "a change of the scene", task);
    }
  }

  /** Called at the end of every step, on the stepping thread. */
  public void onStep(Runnable listener) {
    stepListeners.add(listener);
  }

  /** Whether time passes: while not, steps only run posted tasks. */
  public boolean running() {
    return running;
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
    lock.lock();
    try {
      frame(now, motion);
      stepListeners.forEach(Runnable::run);
    } finally {
      lock.unlock();
    }
  }

  private void frame(double now, ViewerMotion motion) {
    double dt = Double.isNaN(time) ? 0 : Math.max(0, now - time);
    time = now;
    cascade.at(now);
    runDeferred();
    for (int open = posted.size(); open > 0; open--) {
      Runnable task = posted.poll();
      if (task != null) {
        task.run();
      }
    }
    cascade.run();
    instances.update();
    bindables.update(cascade);
    if (!running) {
      return;
    }
    follower.follow();
    motion.move(viewer, now, dt);
    Vector3d up = viewer.orientation().transform(new Vector3d(0, 1, 0));
    instances.view(viewer.position(), up, cascade);
    instances.update();
    WorldFrame frame = new WorldFrame(now, viewer, instances);
    for (FrameNode node : frameNodes()) {
      node.frame(frame, cascade);
    }
    cascade.run();
    instances.update();
  }

  private List<FrameNode> frameNodes() {
    if (frameNodesOf != instances.structureVersion()) {
      frameNodesOf = instances.structureVersion();
      List<FrameNode> found = new ArrayList<>();
      collect(instances.root(), found);
      frameNodes = found.stream().distinct().toList();
    }
    return frameNodes;
  }

  private static void collect(GroupInstance group, List<FrameNode> found) {
    for (Instance child : group.children()) {
      if (child instanceof GroupInstance inner) {
        collect(inner, found);
      } else if (child.node() instanceof FrameNode node) {
        found.add(node);
      }
    }
  }

  /** Moves the viewer to a viewpoint of the scene: binds it and forgets where the user went. */
  public void goTo(Node viewpoint) {
    bindables.bind(viewpoint, cascade);
    cascade.run();
    follower.jump();
  }

  /** All viewpoints of the scene in document order. */
  public List<Node> viewpoints() {
    return bindables.all("X3DViewpointNode");
  }

  /**
   * Goes to a viewpoint counted from the bound one, around the ends of the list.
   *
   * @param steps +1 for the next, -1 for the one before
   */
  public void goToViewpoint(int steps) {
    List<Node> all = viewpoints();
    if (!all.isEmpty()) {
      int at = bindables.bound("X3DViewpointNode").map(all::indexOf).orElse(-1);
      goTo(all.get(Math.floorMod(at + steps, all.size())));
    }
  }

  /** The place of a viewpoint in the world; the identity when it is in no part of the scene. */
  public Matrix4d placeOf(Node viewpoint) {
    return follower.placeOf(viewpoint);
  }
}
