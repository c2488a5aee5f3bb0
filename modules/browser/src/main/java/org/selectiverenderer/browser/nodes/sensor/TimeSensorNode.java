package org.selectiverenderer.browser.nodes.sensor;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.NamedMetadata;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * TimeSensor: a clock (X3D 4.0, 8.4.1). Besides the events of every {@link TimeDependentNode} it
 * sends cycleTime at the beginning of a cycle, with the exact beginning as value, then
 * fraction_changed, and time, the frame's time.
 *
 * <p>A MetadataDouble {@value #RATE} in its metadata says how many fractions a second it sends at
 * most, so that what moves by it moves in steps; 0 lets it stand still. Other browsers pass it over
 * and send one in each frame.
 */
public final class TimeSensorNode extends TimeDependentNode {
  /** The name of the MetadataDouble with the most fractions a second. */
  public static final String RATE = "animationRate";

  /** The tick of the last fraction that was sent. */
  private double sent = Double.NaN;

  /** The seconds since the start at the last frame. */
  private double before;

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

  /** Returns whether a fraction is due, as the animation rate wants it. */
  private boolean due(double elapsed, double part) {
    double rate =
        NamedMetadata.find(this, "MetadataDouble", RATE)
            .map(metadata -> (double[]) metadata.value(metadata.type().indexOf("value")))
            .filter(values -> values.length > 0)
            .map(values -> values[0])
            .orElse(Double.POSITIVE_INFINITY);
    if (rate == Double.POSITIVE_INFINITY || !(rate >= 0)) {
      return true;
    }
    if (elapsed < before) {
      sent = Double.NaN; // It has started anew.
    }
    before = elapsed;
    double tick = Math.floor(elapsed * rate);
    boolean due = rate > 0 && (tick != sent || part == 1); // The end is to be where it belongs.
    sent = tick;
    return due;
  }

  /**
   * A frame exactly at the end of a cycle has the fraction 1 of that cycle, not 0 of the next (X3D
   * 4.0, 8.4.1).
   */
  @Override
  protected void stands(double elapsed, double part, EventCascade cascade) {
    if (due(elapsed, part)) {
      emit(fraction, part == 0 && elapsed > 0 ? 1f : (float) part, cascade);
    }
    emit(time, cascade.time(), cascade);
  }
}
