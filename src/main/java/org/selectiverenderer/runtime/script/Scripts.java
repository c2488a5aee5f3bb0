package org.selectiverenderer.runtime.script;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.script.ScriptProgram;

/**
 * The Scripts of a scene that runs: which there are, and when their functions are called. A Script
 * that neither receives anything nor defines {@code prepareEvents} costs nothing in a frame.
 */
public final class Scripts {
  /** Lines printed per file; a script that prints in every frame would drown all else. */
  private static final int MAX_LINES = 50;

  private final ScriptWorld world;
  private final Map<ScriptNode, RunningScript> running = new LinkedHashMap<>();
  private final List<RunningScript> waiting = new ArrayList<>();
  private final List<RunningScript> preparing = new ArrayList<>();
  private final Set<RunningScript> received = new LinkedHashSet<>();
  private final Map<String, Integer> lines = new LinkedHashMap<>();
  private final Vector3d eye = new Vector3d();
  private @Nullable Engine engine;
  private double frameTime = Double.NaN;
  private double framesPerSecond;
  private double speed;
  private final TimeTogether together = new TimeTogether();
  private long calls;

  public Scripts(ScriptWorld world) {
    this.world = world;
  }

  /** Tells which Scripts are in the scene, in document order, whenever its structure changes. */
  public void watch(Collection<ScriptNode> present) {
    if (present.isEmpty() && running.isEmpty()) {
      return;
    }
    Set<ScriptNode> now = Collections.newSetFromMap(new IdentityHashMap<>());
    now.addAll(present);
    for (ScriptNode node : List.copyOf(running.keySet())) {
      if (!now.contains(node)) {
        end(node);
      }
    }
    for (ScriptNode node : present) {
      ScriptProgram program = node.program();
      Scene context = node.context();
      if (program != null && context != null && !running.containsKey(node)) {
        if (engine == null) {
          engine = new Engine(this, world);
        }
        RunningScript script = new RunningScript(node, program, context, this, engine, world);
        running.put(node, script);
        waiting.add(script);
        node.calls(script);
      }
    }
  }

  private void end(ScriptNode node) {
    RunningScript script = running.remove(node);
    script.shutdown();
    node.calls(null);
    waiting.remove(script);
    preparing.remove(script);
    received.remove(script);
  }

  /** Ends all of them: the scene is not shown any more. */
  public void close() {
    List.copyOf(running.keySet()).forEach(this::end);
  }

  /** Starts those that are new. */
  public void start() {
    if (waiting.isEmpty()) {
      return;
    }
    List<RunningScript> all = List.copyOf(waiting);
    waiting.clear();
    all.forEach(RunningScript::start);
    all.forEach(RunningScript::sendFirst);
  }

  void started(RunningScript script) {
    waiting.remove(script);
    if (script.prepares()) {
      preparing.add(script);
    }
  }

  /**
   * A frame begins, before any sensor has looked at it: calls {@code prepareEvents}.
   *
   * @param time of the frame in seconds
   * @param viewer its place in the world
   */
  public void prepare(double time, Vector3dc viewer) {
    if (running.isEmpty()) {
      return;
    }
    double dt = time - frameTime;
    if (dt > 0) {
      framesPerSecond = 1 / dt;
      speed = eye.distance(viewer) / dt;
    }
    frameTime = time;
    eye.set(viewer);
    for (int i = 0; i < preparing.size(); i++) {
      preparing.get(i).prepareEvents();
    }
  }

  void hasReceived(RunningScript script) {
    received.add(script);
  }

  /**
   * The cascade has come to rest: calls {@code eventsProcessed} of all that have received
   * something.
   *
   * @return whether there were any; they may have sent events
   */
  public boolean finish() {
    if (received.isEmpty()) {
      return false;
    }
    List<RunningScript> done = List.copyOf(received);
    received.clear();
    done.forEach(RunningScript::eventsProcessed);
    return true;
  }

  /** How often code of scripts has been called so far. */
  long calls() {
    return calls;
  }

  void called() {
    calls++;
  }

  /** How long scripts have run at the time stamp of now. */
  TimeTogether together() {
    return together;
  }

  /** Of the scene's own time, in the last frame. */
  double framesPerSecond() {
    return framesPerSecond;
  }

  /** The viewer's, in units per second over the last frame. */
  double speed() {
    return speed;
  }

  void print(Location script, String line) {
    int count = lines.merge(script.file(), 1, Integer::sum);
    if (count <= MAX_LINES) {
      world.problems().info(script, line);
    } else if (count == MAX_LINES + 1) {
      world
          .problems()
          .info(
              Location.of(script.file()),
              "scripts have printed %s lines; no more of them are shown".formatted(MAX_LINES));
    }
  }
}
