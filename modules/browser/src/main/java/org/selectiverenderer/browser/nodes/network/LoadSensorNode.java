package org.selectiverenderer.browser.nodes.network;

import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.SleepableNode;
import org.selectiverenderer.browser.nodes.sensor.WakeState;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * LoadSensor: reports the loading of the files that other nodes name (X3D 4.0, 9.4.3). While files
 * are being read it is active and sends the share that is loaded. At the end it sends progress 1,
 * isLoaded TRUE and loadTime, or isLoaded FALSE if a file could not be read or timeOut seconds have
 * passed; then isActive FALSE. For files loaded before its first frame it sends the same events
 * without having been active.
 */
public final class LoadSensorNode extends Node implements SleepableNode {
  /** The loading state of the file that a node names. */
  public enum State {
    /** The node names no file, has {@code load FALSE}, or is of a type whose files are not read. */
    NONE,
    LOADING,
    LOADED,
    FAILED
  }

  private final WakeState rest = new WakeState();
  private Function<Node, State> states = node -> State.NONE;

  /** Whether there are events that have not been sent. */
  private boolean due = true;

  private boolean begun;
  private boolean gaveUp;
  private double since;
  private float told;

  public LoadSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
  }

  /** Sets the function that returns the loading state of a node's file. */
  public void asks(Function<Node, State> of) {
    states = of;
  }

  /** Is called when reading a node's file begins. */
  public void begins(Node node) {
    if (watches(node)) {
      begun = true;
      gaveUp = false;
      rouse();
    }
  }

  /** Is called when a node's file has been read or cannot be read. */
  public void ends(Node node) {
    if (watches(node)) {
      rouse();
    }
  }

  private boolean watches(Node node) {
    return nodes("children").contains(node);
  }

  private void rouse() {
    due = true;
    rest.rouse();
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    boolean asked = due;
    due = false;
    if (asked && !bool("enabled")) {
      begun = false;
      deactivate(cascade);
    } else if (asked || bool("isActive")) {
      look(frame.time(), cascade);
    }
    rest.unless(due || bool("isActive"));
  }

  private void look(double now, EventCascade cascade) {
    List<State> all =
        nodes("children").stream().map(states).filter(state -> state != State.NONE).toList();
    boolean loading = all.contains(State.LOADING);
    boolean active = bool("isActive");
    if (!active && !gaveUp && (loading || begun)) {
      // If loading has ended meanwhile, that is sent in the next frame: a field sends one event per
      // cascade.
      begun = false;
      since = now;
      told = -1;
      send("isActive", true, cascade);
      progress(all, cascade);
    } else if (active && loading && !late(now)) {
      progress(all, cascade);
    } else if (active || !all.isEmpty() && !gaveUp) {
      gaveUp = loading;
      if (all.stream().allMatch(state -> state == State.LOADED)) {
        send("progress", 1f, cascade);
        send("isLoaded", true, cascade);
        send("loadTime", now, cascade);
      } else {
        send("isLoaded", false, cascade);
      }
      deactivate(cascade);
    }
  }

  private boolean late(double now) {
    double most = (Double) value(type().indexOf("timeOut"));
    return most > 0 && now - since >= most;
  }

  /** Sends the loaded share; never 1, which is sent at the end. */
  private void progress(List<State> all, EventCascade cascade) {
    long loaded = all.stream().filter(state -> state == State.LOADED).count();
    float part = loaded == all.size() ? told : (float) loaded / all.size();
    if (part != told) {
      told = part;
      send("progress", part, cascade);
    }
  }

  private void deactivate(EventCascade cascade) {
    if (bool("isActive")) {
      send("isActive", false, cascade);
    }
  }

  private void send(String field, Object value, EventCascade cascade) {
    emit(type().indexOf(field), value, cascade);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    if (field.name().equals("children") || field.name().equals("enabled")) {
      gaveUp = false;
      rouse();
    }
  }

  @Override
  public boolean awake() {
    return rest.awake();
  }

  @Override
  public void wakeBy(@Nullable Runnable caller) {
    rest.wakeBy(caller);
  }
}
