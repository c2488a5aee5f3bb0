package org.selectiverenderer.runtime;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.joml.Matrix4dc;
import org.joml.Vector3dc;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.runtime.collide.MeshTrees;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Fog;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.loading.LiveFiles;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.nodes.bind.BindStacks;
import org.selectiverenderer.runtime.nodes.bind.ViewpointNode;
import org.selectiverenderer.runtime.nodes.key.KeyDevice;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.nodes.sound.AudioClipNode;
import org.selectiverenderer.runtime.nodes.sound.SoundNode;
import org.selectiverenderer.runtime.scene.ApplicationCode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.runtime.script.ScriptWorld;
import org.selectiverenderer.runtime.script.Scripts;
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
  private final ConcurrentLinkedQueue<Runnable> posted = new ConcurrentLinkedQueue<>();
  private final ConcurrentLinkedQueue<Runnable> deferred = new ConcurrentLinkedQueue<>();
  private final List<ReplaceListener> replaceListeners = new ArrayList<>();
  private Scene scene;
  private LayerStack layers;
  private LiveFiles files;
  private Scripts scripts;
  private final KeyDevice keys = new KeyDevice();
  private final MeshTrees meshes = new MeshTrees();
  private boolean cutOff;
  private final ConcurrentLinkedQueue<Pointer> pointed = new ConcurrentLinkedQueue<>();

  /** Fair, since the stepping thread would else take it again before one that waits gets it. */
  private final ReentrantLock lock = new ReentrantLock(true);

  private final List<Runnable> stepListeners = new ArrayList<>();
  private double time = Double.NaN;
  private double epoch = EPOCH;
  private volatile boolean running = true;
  private Picture picture = Picture.DEFAULT;

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
    LiveFiles live = new LiveFiles(loaded, problems, this::post);
    files = live;
    AnchorLinks links = new AnchorLinks(scene, files, problems, linkTarget(live));
    if (layers != null) { // Not for the first scene.
      layers.close();
    }
    layers =
        new LayerStack(
            scene,
            new LayerStack.Parts(live.assets(), meshes, links::follow, cascade),
            viewer,
            picture);
    if (scripts != null) {
      scripts.close();
    }
    scripts = new Scripts(scriptWorld(live, links));
    keys.follow(List.of(), cascade);
    cutOff = false;
    reportCutOff();
  }

  /** Says once that a part of the scene is left out. */
  private void reportCutOff() {
    if (instances().cutOff() && !cutOff) {
      cutOff = true;
      problems.error(
          Location.of(scene.url()),
          "the scene contains itself or has more than %s instances; the rest is left out"
              .formatted(instances().maxInstances()));
    }
  }

  private ScriptWorld scriptWorld(LiveFiles from, AnchorLinks links) {
    return new ScriptWorld() {
      @Override
      public Cascade cascade() {
        return cascade;
      }

      @Override
      public Problems problems() {
        return problems;
      }

      @Override
      public Scene scene() {
        return scene;
      }

      @Override
      public LiveFiles files() {
        return from;
      }

      @Override
      public void show(LoadedScene wanted) {
        post(() -> replace(wanted));
      }

      @Override
      public void follow(ScriptNode script, String[] urls) {
        Scene file = script.context();
        post(() -> links.follow(script, urls, file == null ? scene : file));
      }
    };
  }

  private AnchorLinks.Target linkTarget(LiveFiles from) {
    return new AnchorLinks.Target() {
      @Override
      public void bind(Node viewpoint) {
        bindables().bind(viewpoint, cascade);
      }

      @Override
      public void show(LoadedScene linked) {
        if (files == from) { // Else the world shows another scene by now.
          replace(linked);
        }
      }
    };
  }

  public void onReplace(ReplaceListener listener) {
    replaceListeners.add(listener);
  }

  public Scene scene() {
    return scene;
  }

  /** What is in the scene; in one with layers, in the one that the user walks in. */
  public InstanceTree instances() {
    return layers.active().instances;
  }

  /** Polygons of all layers in their present versions, seen or not. */
  public long shownPolygons() {
    return layers.shownPolygons();
  }

  /** The meshes and images of the scene's nodes. */
  public Assets assets() {
    return files.assets();
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
    return layers.active().bindables;
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
    return layers.active().backdrop().orElse(Backdrop.BLACK);
  }

  /** The fog that the bound Fog makes. */
  public Fog fog() {
    return layers.active().fog();
  }

  /**
   * The layers that are seen, the lowest first (X3D 4.0, 35.2): one for a scene without a LayerSet.
   */
  public List<LayerView> layers() {
    return layers.views();
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
    layers.see(picture);
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
    return layers.anyPointing(Pointing::wantsDrag);
  }

  /** Whether the scene has a drag sensor. */
  public boolean draggable() {
    return layers.all().stream().anyMatch(SceneLayer::draggable);
  }

  /** Whether the pointing device is held for a drag. As of the last step. */
  public boolean dragging() {
    return layers.anyPointing(Pointing::dragging);
  }

  /**
   * What the author says of what the pointing device is over: the descriptions of its sensors or
   * Anchor (X3D 4.0, 20.2.1). As of the last step.
   */
  public List<String> descriptions() {
    return layers.descriptions();
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

  /**
   * Runs a task, such as drawing, while no other thread changes the world. For the stepping thread,
   * between steps.
   */
  public void hold(Runnable task) {
    lock.lock();
    try {
      task.run();
    } finally {
      lock.unlock();
    }
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
    cascade.at(epoch + now);
    frameNodes();
    scripts.start();
    runDeferred();
    runPosted();
    settle();
    if (!running) {
      return;
    }
    layers.active().follower.follow();
    layers.lead();
    motion.move(viewer, now, dt);
    layers.look(cascade);
    keys.frame(cascade);
    layers.point(drain(pointed), cascade);
    frameNodes();
    scripts.prepare(epoch + now, viewer.position());
    layers.sense(epoch + now, cascade);
    settle();
  }

  /** Those of this moment; what they post in turn waits for the next frame. */
  private void runPosted() {
    for (int open = posted.size(); open > 0; open--) {
      Runnable task = posted.poll();
      if (task != null) {
        task.run();
      }
    }
  }

  /** Carries the events sent, and brings up to date what follows the scene. */
  private void settle() {
    carry();
    layers.follow();
    layers.update();
    layers.bind(cascade);
    carry(); // Nodes that came or went may have been bound or unbound.
    layers.update();
    frameNodes();
    reportCutOff();
    files.update();
  }

  /**
   * Calls listeners and scripts until none sends anything more; scripts call each other so often.
   */
  private void carry() {
    cascade.run();
    while (scripts.finish()) {
      cascade.run();
    }
  }

  private static <T> List<T> drain(Queue<T> queue) {
    List<T> drained = new ArrayList<>();
    for (T next = queue.poll(); next != null; next = queue.poll()) {
      drained.add(next);
    }
    return drained;
  }

  /** Follows the structure of the scene with the nodes that look at every frame. */
  private void frameNodes() {
    if (layers.frameNodes()) {
      files.watch(layers.gathered(SceneLayer::inlines));
      files.watchClips(clips());
      files.watchFrameNodes(layers.gathered(SceneLayer::looking));
      scripts.watch(layers.gathered(SceneLayer::scripts));
      keys.follow(layers.gathered(SceneLayer::keySensors), cascade);
    }
  }

  /** What is heard as of the last step: nothing in a scene without a Sound. */
  public List<Voice> voices() {
    List<SoundNode> sounds = layers.gathered(SceneLayer::sounds);
    return sounds.isEmpty()
        ? List.of()
        : sounds.stream().flatMap(sound -> sound.voice().stream()).toList();
  }

  private List<AudioClipNode> clips() {
    return layers.gathered(SceneLayer::sounds).stream()
        .flatMap(sound -> sound.clip().stream())
        .toList();
  }

  /**
   * Has pictures wait for those of films. Where times are not those of a clock, what is seen must
   * not depend on how fast this machine decodes.
   */
  public void waitForFilms() {
    files.waitForFilms();
  }

  /** Moves the viewer to a viewpoint of the scene: binds it and forgets where the user went. */
  public void goTo(Node viewpoint) {
    hold(
        () -> {
          bindables().bind(viewpoint, cascade);
          cascade.run();
          layers.active().follower.jump();
        });
  }

  /**
   * Takes the viewer to where all that is shown is seen at once.
   *
   * @return whether there is anything to see
   */
  public boolean viewAll() {
    boolean[] moved = new boolean[1];
    hold(() -> moved[0] = layers.active().follower.viewAll());
    return moved[0];
  }

  /**
   * Takes the viewer to where the shape that is pointed at is seen as a whole (X3D 4.0, 23.4.4:
   * LOOKAT).
   *
   * @return whether there is one that does nothing by itself when it is clicked on
   */
  public boolean lookAt() {
    boolean[] moved = new boolean[1];
    hold(
        () -> {
          Optional<Pointer> latest = pointed.stream().reduce((before, after) -> after);
          Optional<Bounds> box = layers.pointedAt(latest).map(shape -> Bounds.of(shape.bounds()));
          box.ifPresent(layers.active().follower::look);
          moved[0] = box.isPresent();
        });
    return moved[0];
  }

  /**
   * The middle of what the viewer was taken to see by {@link #viewAll}, {@link #lookAt} or a
   * viewpoint with {@code viewAll}; empty once another viewpoint is bound.
   */
  public Optional<Vector3dc> centre() {
    return layers.active().follower.centre();
  }

  /**
   * How often the viewer was taken to another viewpoint that an event has bound. Who moves the
   * viewer may make a transition of it (X3D 4.0, 23.3.1).
   */
  public int jumps() {
    return layers.active().follower.jumps();
  }

  /**
   * The viewpoints of the scene, or of its active layer, in document order; those that a
   * ViewpointGroup hides are left out.
   */
  public List<Node> viewpoints() {
    return bindables().all("X3DViewpointNode").stream()
        .filter(layers.active().follower::offers)
        .toList();
  }

  /**
   * Goes to a viewpoint counted from the bound one, around the ends of the list.
   *
   * @param steps +1 for the next, -1 for the one before
   */
  public void goToViewpoint(int steps) {
    List<Node> all = viewpoints();
    if (!all.isEmpty()) {
      int at = bindables().bound("X3DViewpointNode").map(all::indexOf).orElse(-1);
      goTo(all.get(Math.floorMod(at + steps, all.size())));
    }
  }

  /** Where a viewpoint looks from: takes the viewer's frame, looking along -Z, to the world. */
  public Matrix4dc poseOf(Node viewpoint) {
    ViewpointFollower follower = layers.active().follower;
    return viewpoint instanceof ViewpointNode known
        ? follower.poseOf(known)
        : follower.placeOf(viewpoint);
  }

  /** The place of a viewpoint in the world; the identity when it is in no part of the scene. */
  public Matrix4dc placeOf(Node viewpoint) {
    return layers.active().follower.placeOf(viewpoint);
  }
}
