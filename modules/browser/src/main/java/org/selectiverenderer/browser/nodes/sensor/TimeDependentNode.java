package org.selectiverenderer.browser.nodes.sensor;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A time-dependent node (X3D 4.0, 8.2.4): it runs from startTime to the end of a cycle, to
 * stopTime, or for ever. Per frame it sends, in this order: isActive TRUE when it starts, isPaused,
 * the node type's events at the beginning of a cycle, elapsedTime, the node type's events for the
 * present time, and isActive FALSE when it ends.
 *
 * <p>A run that ends between two frames still ends exactly at the end of its cycle, and one that
 * lies entirely between two frames is run in the later one. Paused time counts neither as elapsed
 * nor towards the cycle.
 */
public abstract class TimeDependentNode extends Node implements FrameDrivenNode {
  private final Fields fields;
  private double lastFrame = Double.NaN;
  private double started;
  private double pausedSince;
  private double pausedFor;
  private double cycle;
  private boolean newCycle;

  /** The indices of the node's fields. */
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

  protected TimeDependentNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    fields = Fields.of(type);
  }

  /** Returns the duration of a cycle in seconds; the node does not start unless it is above 0. */
  protected abstract double interval();

  /** Returns whether a field ignores events while the node runs. */
  protected abstract boolean fixedWhileActive(int field);

  /**
   * Is called at the beginning of a cycle.
   *
   * @param at the exact beginning of the cycle, not the frame's time
   */
  protected void begins(double at, EventCascade cascade) {}

  /**
   * Is called in each frame with the present time.
   *
   * @param elapsed the seconds since the start, without pauses
   * @param fraction the fraction of the present cycle, 0 to 1; 1 only at the end of the last cycle
   */
  protected abstract void stands(double elapsed, double fraction, EventCascade cascade);

  /** Returns whether the node runs; a paused node does. */
  public final boolean active() {
    return is(fields.isActive);
  }

  /** Returns whether the node is paused. */
  public final boolean paused() {
    return is(fields.isPaused);
  }

  /** Returns whether the node runs, or will run by its present fields. */
  protected final boolean expectant() {
    return active()
        || is(fields.enabled) && (Double.isNaN(lastFrame) || seconds(fields.startTime) > lastFrame);
  }

  /** Skips the time before a given time, in which the node was asleep. */
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
  public void frame(FrameContext frame, EventCascade cascade) {
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
      end(cascade); // A reaction to isActive disabled it.
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

  private void tick(double now, EventCascade cascade) {
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

  /** Returns whether the node pauses; not before the time already sent. */
  private boolean pauses(double until) {
    double pause = seconds(fields.pauseTime);
    if (pause > seconds(fields.resumeTime) && pause >= started && pause <= until) {
      pausedSince = lastFrame > pause ? lastFrame : pause;
      return true;
    }
    return false;
  }

  /** Sends the events for a time, and ends the run if its last cycle is over by then. */
  private void advance(double until, EventCascade cascade) {
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

  private void end(EventCascade cascade) {
    if (is(fields.isPaused)) {
      emit(fields.isPaused, false, cascade);
    }
    if (active()) {
      emit(fields.isActive, false, cascade);
    }
  }

  /**
   * A running node ignores startTime, fields that are {@link #fixedWhileActive}, and a stopTime
   * that is not after its start. A node that is disabled sends its last events and ends.
   */
  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
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
