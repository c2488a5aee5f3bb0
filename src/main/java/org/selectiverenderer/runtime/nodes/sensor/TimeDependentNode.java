package org.selectiverenderer.runtime.nodes.sensor;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A node that runs in time (X3D 4.0, 8.2.4): from startTime to the end of a cycle, to stopTime, or
 * for ever. Per frame it sends, in this order: isActive TRUE when it starts, isPaused, what a node
 * type sends at the beginning of a cycle, elapsedTime, what a node type sends of where it stands,
 * and isActive FALSE when it ends.
 *
 * <p>A run that ends between two frames still ends where its cycle does, and one that lies between
 * two frames altogether is run in the later one. Seconds that it is paused count neither as elapsed
 * nor towards the cycle.
 */
public abstract class TimeDependentNode extends Node implements FrameNode {
  private final Fields fields;
  private double lastFrame = Double.NaN;
  private double started;
  private double pausedSince;
  private double pausedFor;
  private double cycle;
  private boolean newCycle;

  /** The indexes of its fields. */
  private record Fields(
      int enabled,
      int loop,
      int startTime,
      int stopTime,
      int pauseTime,
      int resumeTime,
      int isActive,
      int isPaused,
      int elapsedTime) {
    static Fields of(NodeType type) {
      return new Fields(
          type.indexOf("enabled"),
          type.indexOf("loop"),
          type.indexOf("startTime"),
          type.indexOf("stopTime"),
          type.indexOf("pauseTime"),
          type.indexOf("resumeTime"),
          type.indexOf("isActive"),
          type.indexOf("isPaused"),
          type.indexOf("elapsedTime"));
    }
  }

  protected TimeDependentNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    fields = Fields.of(type);
  }

  /** Seconds that a cycle takes; it does not start unless that is above 0. */
  protected abstract double interval();

  /** Whether a field keeps its value while the node runs, whatever events arrive at it. */
  protected abstract boolean fixedWhileActive(int field);

  /**
   * A cycle begins.
   *
   * @param at its true beginning, not the frame's time
   */
  protected void begins(double at, Cascade cascade) {}

  /**
   * Where it stands in this frame.
   *
   * @param elapsed seconds since it began, without pauses
   * @param fraction of the present cycle, 0 to 1; 1 only at the end of the last
   */
  protected abstract void stands(double elapsed, double fraction, Cascade cascade);

  /** Whether it runs; one that is paused does. */
  public final boolean active() {
    return is(fields.isActive);
  }

  /** Whether it is paused. */
  public final boolean paused() {
    return is(fields.isPaused);
  }

  /** Whether it runs, or will by the fields that it has now. */
  protected final boolean expectant() {
    return active()
        || is(fields.enabled) && (Double.isNaN(lastFrame) || seconds(fields.startTime) > lastFrame);
  }

  /** What a node that did not look at frames has missed until a time is no longer run. */
  protected final void restedUntil(double time) {
    lastFrame = Math.max(lastFrame, time);
  }

  private boolean is(int field) {
    return (Boolean) value(field);
  }

  protected final double seconds(int field) {
    return (Double) value(field);
  }

  @Override
  public void frame(Frame frame, Cascade cascade) {
    double now = frame.time();
    if (!active() && mayStart(now)) {
      started = seconds(fields.startTime);
      pausedFor = 0;
      cycle = is(fields.loop) ? Math.floor((now - started) / interval()) : 0;
      newCycle = true;
      emit(fields.isActive, true, cascade);
    }
    if (active() && is(fields.enabled)) {
      tick(now, cascade);
    } else {
      end(cascade); // An answer to its own isActive disabled it.
    }
    lastFrame = now;
  }

  private boolean mayStart(double now) {
    double start = seconds(fields.startTime);
    double stop = seconds(fields.stopTime);
    double interval = interval();
    if (!is(fields.enabled) || !(interval > 0) || !(start <= now) || stop > start && stop <= now) {
      return false;
    }
    return is(fields.loop) || now < start + interval || start >= lastFrame;
  }

  private void tick(double now, Cascade cascade) {
    double stop = seconds(fields.stopTime);
    boolean stops = stop > started && stop <= now;
    double until = stops ? stop : now;
    boolean paused = is(fields.isPaused);
    if (paused) {
      paused = !resumes(until);
      if (!paused) {
        emit(fields.isPaused, false, cascade);
      }
    }
    if (!paused && pauses(until)) {
      advance(pausedSince, cascade);
      if (active()) {
        emit(fields.isPaused, true, cascade);
      }
    } else if (!paused) {
      advance(until, cascade);
    }
    if (stops) {
      end(cascade);
    }
  }

  private boolean resumes(double until) {
    double resume = seconds(fields.resumeTime);
    if (resume > seconds(fields.pauseTime) && resume <= until) {
      pausedFor += Math.max(resume, pausedSince) - pausedSince;
      return true;
    }
    return false;
  }

  /** Whether it pauses; not earlier than what it already sent. */
  private boolean pauses(double until) {
    double pause = seconds(fields.pauseTime);
    if (pause > seconds(fields.resumeTime) && pause >= started && pause <= until) {
      pausedSince = lastFrame > pause ? lastFrame : pause;
      return true;
    }
    return false;
  }

  /** Sends where the clock stands at a time, and ends it when its last cycle is over by then. */
  private void advance(double until, Cascade cascade) {
    double interval = interval();
    double elapsed = until - started - pausedFor;
    double whole = Math.floor(elapsed / interval);
    boolean over = !is(fields.loop) && whole > cycle;
    if (over) {
      elapsed = (cycle + 1) * interval;
    } else if (whole > cycle) {
      cycle = whole;
      newCycle = true;
    }
    if (newCycle) {
      newCycle = false;
      begins(started + pausedFor + cycle * interval, cascade);
    }
    emit(fields.elapsedTime, elapsed, cascade);
    stands(elapsed, over ? 1 : elapsed / interval - whole, cascade);
    if (over) {
      end(cascade);
    }
  }

  private void end(Cascade cascade) {
    if (is(fields.isPaused)) {
      emit(fields.isPaused, false, cascade);
    }
    if (active()) {
      emit(fields.isActive, false, cascade);
    }
  }

  /**
   * One that runs ignores startTime, what is {@link #fixedWhileActive}, and a stopTime that is not
   * after its start; one that is disabled sends where it stands and ends.
   */
  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    int index = field.index();
    if (active()
        && (index == fields.startTime
            || fixedWhileActive(index)
            || index == fields.stopTime && (Double) value <= started)) {
      return;
    }
    super.receive(field, value, cascade);
    if (index == fields.enabled && active() && !is(fields.enabled)) {
      if (!is(fields.isPaused)) {
        advance(Math.max(started, cascade.time()), cascade);
      }
      end(cascade);
    }
  }
}
