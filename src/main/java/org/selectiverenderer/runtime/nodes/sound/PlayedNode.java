package org.selectiverenderer.runtime.nodes.sound;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.nodes.sensor.Frame;
import org.selectiverenderer.runtime.nodes.sensor.Rest;
import org.selectiverenderer.runtime.nodes.sensor.Sleeper;
import org.selectiverenderer.runtime.nodes.sensor.TimeDependentNode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * What plays a file (X3D 4.0, 16.3.5): without one it does not run. It is led by the frames of all
 * that it stands in; of several in one frame the first counts.
 */
public abstract class PlayedNode extends TimeDependentNode implements Sleeper {
  private final int url;
  private final int load;
  private final int duration;
  private final Rest rest = new Rest();
  private double seconds = Double.NaN;
  private boolean durationDue;
  private double elapsed;
  private double lookedAt = Double.NaN;

  PlayedNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    url = type.indexOf("url");
    load = type.indexOf("load");
    duration = type.indexOf("duration_changed");
  }

  /** The field that names its file. */
  public final int urlField() {
    return url;
  }

  /** The field that says whether the file is wanted. */
  public final int loadField() {
    return load;
  }

  /**
   * It has got another file; duration_changed is sent in the next frame.
   *
   * @param time that the file takes at its own rate; NaN without a file
   */
  final void takes(double time) {
    seconds = time;
    durationDue = true;
    rest.rouse();
    tellObservers(duration);
  }

  /** Whether it has a file that it can play. */
  public final boolean loaded() {
    return !Double.isNaN(seconds);
  }

  /** What its file takes at its own rate, in seconds; NaN without a file. */
  final double seconds() {
    return seconds;
  }

  /** Seconds since it began, without pauses. */
  final double elapsed() {
    return elapsed;
  }

  /** How much faster than at its own rate it runs, either way. */
  abstract double rate();

  @Override
  protected final double interval() {
    return seconds / rate();
  }

  @Override
  protected final void stands(double since, double fraction, Cascade cascade) {
    elapsed = since;
    stands(fraction);
  }

  /**
   * Where it stands in this frame.
   *
   * @param fraction of the present cycle, 0 to 1
   */
  abstract void stands(double fraction);

  @Override
  public final void frame(Frame frame, Cascade cascade) {
    if (frame.time() == lookedAt) {
      return;
    }
    lookedAt = frame.time();
    if (durationDue) {
      durationDue = false;
      emit(duration, Double.isNaN(seconds) ? -1.0 : seconds, cascade);
    }
    super.frame(frame, cascade);
    rest.unless(expectant());
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (!rest.awake()) {
      restedUntil(cascade.time());
    }
    super.receive(field, value, cascade);
    rest.rouse();
  }

  @Override
  public final boolean awake() {
    return rest.awake();
  }

  @Override
  public final void wakeBy(@Nullable Runnable caller) {
    rest.wakeBy(caller);
  }
}
