package org.selectiverenderer.browser.script;

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
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.script.ScriptProgram;

/**
 * Schedules the Scripts of a running scene: keeps track of them and calls their functions at the
 * right times. A Script that neither receives events nor defines {@code prepareEvents} costs
 * nothing in a frame.
 */
public final class ScriptScheduler {
  /**
   * The most printed lines per file, so that a script that prints in every frame does not hide
   * other messages.
   */
  private static final int MAX_LINES = 50;

  private final ScriptHost world;
  private final ScriptTimeBudget budget;
  private final ScriptLimits limits;
  private final Map<ScriptNode, RunningScript> running = new LinkedHashMap<>();
  private final List<RunningScript> waiting = new ArrayList<>();
  private final List<RunningScript> preparing = new ArrayList<>();
  private final Set<RunningScript> received = new LinkedHashSet<>();
  private final Map<String, Integer> lines = new LinkedHashMap<>();
  private final Vector3d eye = new Vector3d();
  private @Nullable RhinoEngine engine;
  private double frameTime = Double.NaN;
  private double framesPerSecond;
  private double speed;
  private long calls;
  private boolean startsTooLong;
  private boolean callsTooLong;

  /**
   * @param budget the time that all scripts may take, also those of scenes shown before
   */
  public ScriptScheduler(ScriptHost world, ScriptTimeBudget budget) {
    this(world, budget, ScriptLimits.standard());
  }

  ScriptScheduler(ScriptHost world, ScriptTimeBudget budget, ScriptLimits limits) {
    this.world = world;
    this.budget = budget;
    this.limits = limits;
  }

  /**
   * Sets the Scripts that are in the scene, in document order; called whenever its structure
   * changes.
   */
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
          engine = new RhinoEngine(this, world, limits);
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

  /** Ends all Scripts when the scene is not shown any more. */
  public void close() {
    List.copyOf(running.keySet()).forEach(this::end);
  }

  /** Starts the new Scripts. */
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
   * Calls {@code prepareEvents} at the beginning of a frame, before any sensor is evaluated.
   *
   * @param time of the frame in seconds
   * @param viewer the viewer's position in the world
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
   * Calls {@code eventsProcessed} of all Scripts that have received events, after the cascade.
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

  /** Returns how often code of scripts has been called so far. */
  long calls() {
    return calls;
  }

  void called() {
    calls++;
  }

  /** Returns the time by the clock that measures calls, in nanoseconds. */
  long nanoTime() {
    return limits.clock().getAsLong();
  }

  /** Returns the time budget that all scripts share. */
  ScriptTimeBudget budget() {
    return budget;
  }

  /**
   * Reports, once for each kind, that the scripts have used up their time.
   *
   * @param starting whether that is the time to start
   * @param at the place of the script that ran last
   * @param name that script's name
   */
  void overBudget(boolean starting, SourceLocation at, String name) {
    if (starting && !startsTooLong) {
      startsTooLong = true;
      world
          .problems()
          .error(
              at,
              "%s: the scripts of the scene have taken more than %s s to start; those not started are switched off"
                  .formatted(name, Math.round(budget.starting().most())));
    } else if (!starting && !callsTooLong) {
      callsTooLong = true;
      world
          .problems()
          .error(
              at,
              "%s: the scripts of the scene have run for %s s more than its time allows; events to them are dropped until it has caught up"
                  .formatted(name, Math.round(budget.calling().most())));
    }
  }

  /** Returns the frame rate of the last frame in the scene's time. */
  double framesPerSecond() {
    return framesPerSecond;
  }

  /** Returns the viewer's speed over the last frame, in units per second. */
  double speed() {
    return speed;
  }

  void print(SourceLocation script, String line) {
    int count = lines.merge(script.file(), 1, Integer::sum);
    if (count <= MAX_LINES) {
      world.problems().info(script, line);
    } else if (count == MAX_LINES + 1) {
      world
          .problems()
          .info(
              SourceLocation.of(script.file()),
              "scripts have printed %s lines; no more of them are shown".formatted(MAX_LINES));
    }
  }
}
