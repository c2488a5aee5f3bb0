package org.selectiverenderer.browser.script;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.RhinoException;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.script.ScriptEventReceiver;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.script.UnsupportedSyntax;

/**
 * A Script node with its running program. It starts with the first frame or the first event,
 * whichever comes first. After it was stopped at a limit, or has failed too often, it is switched
 * off for good.
 */
final class RunningScript implements ScriptEventReceiver {
  /** The most characters of a printed line. */
  private static final int MAX_PRINTED = 2000;

  /** The number of failures after which a script is switched off. */
  private static final int MAX_FAILURES = 20;

  /**
   * The number of calls at one time stamp after which scripts are assumed to trigger each other
   * endlessly.
   */
  private static final int MAX_CALLS = 10_000;

  private final ScriptNode node;
  private final ScriptProgram program;
  private final Scene context;
  private final ScriptScheduler scripts;
  private final RhinoEngine engine;
  private final ScriptHost world;
  private final ScriptFieldValues own;
  private ScriptScope scope;
  private final ScriptNodeAccess nodes;
  private final Set<String> told = new HashSet<>();
  private @Nullable SceneObject contextObject;
  private boolean started;
  private boolean off;
  private int failures;
  private int calls;
  private double callsAt = Double.NaN;
  private org.mozilla.javascript.@Nullable Function prepareEvents;
  private org.mozilla.javascript.@Nullable Function eventsProcessed;

  RunningScript(
      ScriptNode node,
      ScriptProgram program,
      Scene context,
      ScriptScheduler scripts,
      RhinoEngine engine,
      ScriptHost world) {
    this.node = node;
    this.program = program;
    this.context = context;
    this.scripts = scripts;
    this.engine = engine;
    this.world = world;
    own = new ScriptFieldValues(node, engine.values());
    nodes =
        new ScriptNodeAccess(
            node,
            own,
            engine.values(),
            what -> world.problems().info(node.location(), name() + " " + what));
    scope = new ScriptScope(node.type(), own, engine.shared());
  }

  ScriptNode node() {
    return node;
  }

  /** Returns the nodes of the scene as the script reads and writes them. */
  ScriptNodeAccess nodes() {
    return nodes;
  }

  /** Returns the scene that contains the Script. */
  Scene context() {
    return context;
  }

  /** Returns that scene as its program sees it. */
  SceneObject contextObject(Supplier<SceneObject> maker) {
    if (contextObject == null) {
      contextObject = maker.get();
    }
    return contextObject;
  }

  /** Returns whether it defines {@code prepareEvents} and so is called in every frame. */
  boolean prepares() {
    return prepareEvents != null && !off;
  }

  /** Runs the program's top-level statements and its {@code initialize}, once. */
  void start() {
    if (started) {
      return;
    }
    started = true;
    EventCascade cascade = world.cascade();
    run(
        true,
        cascade,
        cx -> {
          cx.compileString(program.text(), "script", 1, null).exec(cx, scope, scope);
          prepareEvents = scope.function("prepareEvents");
          eventsProcessed = scope.function("eventsProcessed");
          org.mozilla.javascript.Function initialize = scope.function("initialize");
          return initialize == null ? null : initialize.call(cx, scope, scope, stamp(cascade));
        });
    scripts.started(this);
  }

  /**
   * Sends the values that the start has assigned. This is done after all scripts that start
   * together have started, so that none receives an event before its {@code initialize} (X3D 4.0,
   * 29.2.4).
   */
  void sendFirst() {
    send(world.cascade());
  }

  private static Object[] stamp(EventCascade cascade) {
    return new Object[] {cascade.time()};
  }

  @Override
  public void received(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (!started) {
      start();
      send(cascade);
    }
    own.forget(field);
    org.mozilla.javascript.Function answer = off ? null : scope.answerTo(field);
    if (answer != null) {
      run(
          false,
          cascade,
          cx -> {
            Object given = engine.values().toScript(field.type(), value, null);
            return answer.call(cx, scope, scope, new Object[] {given, cascade.time()});
          });
      send(cascade);
    }
    if (eventsProcessed != null) {
      scripts.hasReceived(this);
    }
  }

  /** Calls {@code prepareEvents}, before a frame. */
  void prepareEvents() {
    call(prepareEvents);
  }

  /** Calls {@code eventsProcessed}, after the events of a time stamp. */
  void eventsProcessed() {
    call(eventsProcessed);
  }

  /** Calls {@code shutdown}, after the Script has left the scene. */
  void shutdown() {
    if (started) {
      call(scope.function("shutdown"));
      off = true;
    }
  }

  private void call(org.mozilla.javascript.@Nullable Function function) {
    if (function != null && !off) {
      EventCascade cascade = world.cascade();
      run(false, cascade, cx -> function.call(cx, scope, scope, stamp(cascade)));
      send(cascade);
    }
  }

  private void run(
      boolean starting, EventCascade cascade, Function<Context, @Nullable Object> code) {
    ScriptTimeBudget.Used budget =
        starting ? scripts.budget().starting() : scripts.budget().calling();
    if (budget.over(cascade.time())) {
      off |= starting; // It cannot be called without having started.
      return;
    }
    if (tooMany(cascade)) {
      return;
    }
    scripts.called();
    long began = scripts.nanoTime();
    guarded(starting, code);
    double took = (scripts.nanoTime() - began) * 1e-9;
    if (budget.add(cascade.time(), took)) {
      scripts.overBudget(starting, program.start(), name());
    }
  }

  /** Runs code under the limits of a call; whatever it does ends this script only. */
  private void guarded(boolean starting, Function<Context, @Nullable Object> code) {
    try {
      engine.call(
          this,
          starting,
          cx -> {
            code.apply(cx);
            return this;
          });
    } catch (ScriptStoppedError e) {
      switchOff(program.line(e.line()), e.getMessage());
    } catch (OutOfMemoryError e) {
      switchOff(program.start(), "it ran out of memory");
    } catch (StackOverflowError e) {
      switchOff(program.start(), "calls are nested too deeply");
    } catch (EvaluatorException e) { // Of the parser.
      String line = e.lineSource() == null ? "" : e.lineSource();
      String what = UnsupportedSyntax.explained(e.details(), line, e.columnNumber());
      failed(program.line(e.lineNumber()), what);
    } catch (RhinoException e) {
      failed(program.line(e.lineNumber()), e.details());
    } catch (RuntimeException e) {
      failed(program.start(), "a function of the browser failed: " + e);
    } catch (InternalError | UnknownError e) {
      throw e; // The virtual machine is broken, not the script.
    } catch (Error e) {
      switchOff(program.start(), "it broke the script engine: " + e);
    }
  }

  /**
   * Sends what a function has assigned and changed. To take the values of large arrays is work of
   * the script, so it is done under the limits of a call.
   */
  private void send(EventCascade cascade) {
    Map<FieldDefinition, @Nullable Object> taken = new LinkedHashMap<>();
    List<PendingWrites.Sent> written = new ArrayList<>();
    guarded(
        false,
        cx -> {
          taken.putAll(own.take());
          return null;
        });
    guarded(
        false,
        cx -> {
          written.addAll(nodes.take());
          return null;
        });
    own.send(taken, cascade);
    ScriptNodeAccess.send(written, cascade);
    if (off) {
      release();
    }
  }

  /** Drops what the program holds. */
  private void release() {
    own.clear();
    nodes.clear();
    prepareEvents = null;
    eventsProcessed = null;
    scope = new ScriptScope(node.type(), own, engine.shared());
  }

  private boolean tooMany(EventCascade cascade) {
    if (callsAt != cascade.time()) {
      callsAt = cascade.time();
      calls = 0;
    }
    if (++calls == MAX_CALLS) {
      problem(
          program.start(),
          "it was called %s times at one time stamp, as if scripts triggered each other endlessly; "
                  .formatted(MAX_CALLS)
              + "further events of this time stamp are dropped");
    }
    return calls >= MAX_CALLS;
  }

  private void failed(SourceLocation at, String what) {
    failures++;
    if (told.add(at + what)) {
      problem(at, what);
    }
    if (failures == MAX_FAILURES) {
      switchOff(at, "it has failed %s times".formatted(MAX_FAILURES));
    }
  }

  private void switchOff(SourceLocation at, String why) {
    if (!off) {
      off = true;
      problem(at, why + "; the Script is switched off");
    }
  }

  /**
   * Reports a problem at its place in the code; if the code is in another file, the message also
   * names the place of the Script.
   */
  private void problem(SourceLocation at, String what) {
    world.problems().error(at, name() + ": " + what);
  }

  /** Returns the Script's name in messages. */
  private String name() {
    String name = node.name() == null ? "Script" : "Script " + node.name();
    boolean here = program.start().file().equals(node.location().file());
    return here ? name : name + " of " + node.location();
  }

  /** Reports what the script prints. */
  void print(String text) {
    String shown = text.length() <= MAX_PRINTED ? text : text.substring(0, MAX_PRINTED) + "…";
    scripts.print(node.location(), name() + " prints: " + shown);
  }
}
