package org.selectiverenderer.browser.nodes.follow;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.SleepableNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A node whose value follows a destination (X3D 4.0, X3DFollowerNode, 39.3.3). A new destination
 * sends {@code isActive TRUE}; each later frame sends {@code value_changed}, the last one with the
 * destination itself and {@code isActive FALSE}. {@code set_value} is forwarded at once and starts
 * a transition from there. With a duration of 0 a destination is forwarded at once.
 */
abstract class FollowerNode extends Node implements SleepableNode {
  final FollowerValueSpace space;
  private final int setDestination;
  private final int setValue;
  private final int initialDestination;
  private final int initialValue;
  private final int valueChanged;
  private final int isActive;
  private final boolean scalar;
  private @Nullable Object goal;
  private double[] destination = {};
  private @Nullable FollowerResponse response;
  private @Nullable Runnable wake;
  private double since = Double.NaN;

  FollowerNode(
      NodeType type, @Nullable String name, SourceLocation location, FollowerValueSpace space) {
    super(type, name, location);
    this.space = space;
    setDestination = type.indexOf("set_destination");
    setValue = type.indexOf("set_value");
    initialDestination = type.indexOf("initialDestination");
    initialValue = type.indexOf("initialValue");
    valueChanged = type.indexOf("value_changed");
    isActive = type.indexOf("isActive");
    FieldDefinition output = type.fields().get(valueChanged);
    scalar = !output.type().multiple() && output.type().components() == 1;
  }

  /** Returns the response by which the value reaches its destination; called once. */
  abstract FollowerResponse respond();

  /** Returns whether the present fields make the value jump to its destination at once. */
  abstract boolean immediate();

  private boolean active() {
    return (Boolean) value(isActive);
  }

  /** Awake until the first frame, since initial value and destination may differ. */
  @Override
  public final boolean awake() {
    return response == null || active();
  }

  @Override
  public final void wakeBy(@Nullable Runnable call) {
    wake = call;
  }

  /** Starts with the initial values of the fields. */
  private FollowerResponse begun(EventCascade cascade) {
    FollowerResponse known = response;
    if (known == null) {
      double[] initial = space.read(value(initialValue));
      goal = value(initialDestination);
      destination = space.read(goal);
      known = respond();
      response = known;
      known.start(initial);
      aim(known, cascade);
    }
    return known;
  }

  private void aim(FollowerResponse known, EventCascade cascade) {
    boolean other = known.value().length != destination.length;
    known.aim(destination, cascade.time());
    if (known.arrived() || immediate()) {
      settle(known, other || !known.arrived(), cascade);
    } else if (!active()) {
      since = cascade.time();
      emit(isActive, true, cascade);
      if (wake != null) {
        wake.run();
      }
    }
  }

  /**
   * Stops at the destination.
   *
   * @param changed whether the value was elsewhere before
   */
  private void settle(FollowerResponse known, boolean changed, EventCascade cascade) {
    known.start(destination);
    if (changed) {
      emit(valueChanged, goal, cascade);
    }
    if (active()) {
      emit(isActive, false, cascade);
    }
  }

  @Override
  public final void frame(FrameContext frame, EventCascade cascade) {
    FollowerResponse known = begun(cascade);
    if (active() && frame.time() > since) {
      known.advance(frame.time());
      boolean arrived = known.arrived();
      emit(valueChanged, arrived ? goal : space.write(known.value(), scalar), cascade);
      if (arrived && active()) {
        emit(isActive, false, cascade);
      }
    }
  }

  @Override
  protected final void receive(
      FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.index() == setDestination && value != null) {
      FollowerResponse known = begun(cascade);
      goal = value;
      destination = space.read(value);
      aim(known, cascade);
    } else if (field.index() == setValue && value != null) {
      FollowerResponse known = begun(cascade);
      known.start(space.read(value));
      emit(valueChanged, value, cascade);
      aim(known, cascade);
    } else {
      super.receive(field, value, cascade);
    }
  }
}
