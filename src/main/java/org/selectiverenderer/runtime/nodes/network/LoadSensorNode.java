package org.selectiverenderer.runtime.nodes.network;

import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.nodes.sensor.Frame;
import org.selectiverenderer.runtime.nodes.sensor.Rest;
import org.selectiverenderer.runtime.nodes.sensor.Sleeper;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Tells how the files that other nodes name are coming on (X3D 4.0, 9.4.3). While some are read it
 * is active and tells which part of them is there. At the end it sends progress 1, isLoaded TRUE
 * and loadTime, or isLoaded FALSE where one could not be read or timeOut seconds have gone by; then
 * isActive FALSE. Of files that were there before its first frame it sends the same without having
 * been active.
 */
public final class LoadSensorNode extends Node implements Sleeper {
  /** What has become of the file that a node names. */
  public enum State {
    /** It names none, does not want it, or is of a type whose files are not read. */
    NONE,
    LOADING,
    LOADED,
    FAILED
  }

  private final Rest rest = new Rest();
  private Function<Node, State> states = node -> State.NONE;

  /** Whether there is something to be told that it has not told. */
  private boolean due = true;

  private boolean begun;
  private boolean gaveUp;
  private double since;
  private float told;

  public LoadSensorNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
  }

  /** Says whom to ask what has become of files. */
  public void asks(Function<Node, State> of) {
    states = of;
  }

  /** A node's file begins to be read. */
  public void begins(Node node) {
    if (watches(node)) {
      begun = true;
      gaveUp = false;
      rouse();
    }
  }

  /** A node's file has been read, or cannot be. */
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
  public void frame(Frame frame, Cascade cascade) {
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

  private void look(double now, Cascade cascade) {
    List<State> all =
        nodes("children").stream().map(states).filter(state -> state != State.NONE).toList();
    boolean loading = all.contains(State.LOADING);
    boolean active = bool("isActive");
    if (!active && !gaveUp && (loading || begun)) {
      // One that has ended meanwhile is told in the next frame: FALSE cannot follow in this one.
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

  /** Which part is there; never 1, which is told at the end. */
  private void progress(List<State> all, Cascade cascade) {
    long loaded = all.stream().filter(state -> state == State.LOADED).count();
    float part = loaded == all.size() ? told : (float) loaded / all.size();
    if (part != told) {
      told = part;
      send("progress", part, cascade);
    }
  }

  private void deactivate(Cascade cascade) {
    if (bool("isActive")) {
      send("isActive", false, cascade);
    }
  }

  private void send(String field, Object value, Cascade cascade) {
    emit(type().indexOf(field), value, cascade);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
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
