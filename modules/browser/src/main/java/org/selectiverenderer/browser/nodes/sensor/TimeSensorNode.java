package org.selectiverenderer.browser.nodes.sensor;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * TimeSensor: a clock (X3D 4.0, 8.4.1). Besides the events of every {@link TimeDependentNode} it
 * sends cycleTime at the beginning of a cycle, with the exact beginning as value, then
 * fraction_changed, and time, the frame's time.
 */
public final class TimeSensorNode extends TimeDependentNode {
  private final int cycleInterval;
  private final int cycleTime;
  private final int fraction;
  private final int time;

  public TimeSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    cycleInterval = type.indexOf("cycleInterval");
    cycleTime = type.indexOf("cycleTime");
    fraction = type.indexOf("fraction_changed");
    time = type.indexOf("time");
  }

  @Override
  protected double interval() {
    return seconds(cycleInterval);
  }

  @Override
  protected boolean fixedWhileActive(int field) {
    return field == cycleInterval;
  }

  @Override
  protected void begins(double at, EventCascade cascade) {
    emit(cycleTime, at, cascade);
  }

  /**
   * A frame exactly at the end of a cycle has the fraction 1 of that cycle, not 0 of the next (X3D
   * 4.0, 8.4.1).
   */
  @Override
  protected void stands(double elapsed, double part, EventCascade cascade) {
    emit(fraction, part == 0 && elapsed > 0 ? 1f : (float) part, cascade);
    emit(time, cascade.time(), cascade);
  }
}
