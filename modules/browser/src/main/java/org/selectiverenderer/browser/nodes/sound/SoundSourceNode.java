package org.selectiverenderer.browser.nodes.sound;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.SleepableNode;
import org.selectiverenderer.browser.nodes.sensor.TimeDependentNode;
import org.selectiverenderer.browser.nodes.sensor.WakeState;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A node that plays a media file (X3D 4.0, X3DSoundSourceNode, 16.3.5): AudioClip and MovieTexture.
 * Without a file it does not run. If several parents update it in one frame, the first counts.
 */
public abstract class SoundSourceNode extends TimeDependentNode implements SleepableNode {
  private final int url;
  private final int load;
  private final int duration;
  private final WakeState rest = new WakeState();
  private double seconds = Double.NaN;
  private boolean durationDue;
  private double elapsed;
  private double lookedAt = Double.NaN;

  SoundSourceNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    url = type.indexOf("url");
    load = type.indexOf("load");
    duration = type.indexOf("duration_changed");
  }

  /** Returns the index of the field {@code url}. */
  public final int urlField() {
    return url;
  }

  /** Returns the index of the field {@code load}. */
  public final int loadField() {
    return load;
  }

  /**
   * Notes that the file was replaced; duration_changed is sent in the next frame.
   *
   * @param time the duration of the file at normal rate, in seconds; NaN without a file
   */
  final void takes(double time) {
    seconds = time;
    durationDue = true;
    rest.rouse();
    tellObservers(duration);
  }

  /** Returns whether the node has a file that can be played. */
  public final boolean loaded() {
    return !Double.isNaN(seconds);
  }

  /** Returns the duration of the file at normal rate, in seconds; NaN without a file. */
  final double seconds() {
    return seconds;
  }

  /** Returns the seconds since the start, without pauses. */
  final double elapsed() {
    return elapsed;
  }

  /** Returns the factor of the playback rate; negative for backwards. */
  abstract double rate();

  /** Returns the sound that is audible in this frame; empty while there is none. */
  abstract Optional<AudioBuffer> sounding();

  /** Returns the playback position in seconds from the beginning of the file, at normal rate. */
  abstract double position();

  /** Returns the factor of the loudness, which is not negative. */
  final double gain() {
    return Math.max(0, number("gain"));
  }

  @Override
  protected final double interval() {
    return seconds / rate();
  }

  @Override
  protected final void stands(double since, double fraction, EventCascade cascade) {
    elapsed = since;
    stands(fraction);
  }

  /**
   * Is called in each frame with the present position.
   *
   * @param fraction the fraction of the present cycle, 0 to 1
   */
  abstract void stands(double fraction);

  @Override
  public final void frame(FrameContext frame, EventCascade cascade) {
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
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
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
