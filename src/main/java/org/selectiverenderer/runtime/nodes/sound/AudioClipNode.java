package org.selectiverenderer.runtime.nodes.sound;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.nodes.sensor.Frame;
import org.selectiverenderer.runtime.nodes.sensor.Sleeper;
import org.selectiverenderer.runtime.nodes.sensor.TimeDependentNode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.sound.Recording;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A recording that runs in time (X3D 4.0, 16.4.2). A cycle takes as long as the recording does at
 * the clip's pitch; without a recording it does not run. It is led by the frames of the Sound that
 * it is the source of, or of the scene where it stands in a group itself; of two in one frame the
 * second does nothing.
 */
public final class AudioClipNode extends TimeDependentNode implements Sleeper {
  private final int url;
  private final int load;
  private final int pitch;
  private final int gain;
  private final int duration;
  private @Nullable Recording recording;
  private boolean durationDue;
  private double elapsed;
  private double position;
  private double lookedAt = Double.NaN;
  private boolean awake = true;
  private @Nullable Runnable call;

  public AudioClipNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    url = type.indexOf("url");
    load = type.indexOf("load");
    pitch = type.indexOf("pitch");
    gain = type.indexOf("gain");
    duration = type.indexOf("duration_changed");
  }

  /** The field that names its file. */
  public int urlField() {
    return url;
  }

  /** The field that says whether the file is wanted. */
  public int loadField() {
    return load;
  }

  /** Gives it a recording, or takes it away; duration_changed is sent in the next frame. */
  public void recording(@Nullable Recording found) {
    durationDue |= found != recording;
    recording = found;
    rouse();
    tellObservers(duration);
  }

  /** What is heard of it in this frame; empty while it does not run. */
  Optional<Recording> sounding() {
    return active() && !paused() ? Optional.ofNullable(recording) : Optional.empty();
  }

  /** Seconds from the beginning of the recording, at the recording's own rate. */
  double position() {
    return position;
  }

  /** Seconds since it began, without pauses. */
  double elapsed() {
    return elapsed;
  }

  /** How much faster than at its own rate it runs. */
  double pitch() {
    return (Float) value(pitch);
  }

  double gain() {
    return Math.max(0, (Float) value(gain));
  }

  @Override
  protected double interval() {
    return recording == null ? Double.NaN : recording.seconds() / pitch();
  }

  @Override
  protected boolean fixedWhileActive(int field) {
    return field == pitch;
  }

  @Override
  protected void stands(double since, double fraction, Cascade cascade) {
    elapsed = since;
    position = recording == null ? 0 : fraction * recording.seconds();
  }

  @Override
  public void frame(Frame frame, Cascade cascade) {
    if (frame.time() == lookedAt) {
      return;
    }
    lookedAt = frame.time();
    if (durationDue) {
      durationDue = false;
      emit(duration, recording == null ? -1.0 : recording.seconds(), cascade);
    }
    super.frame(frame, cascade);
    awake = expectant();
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (!awake) {
      restedUntil(cascade.time());
    }
    super.receive(field, value, cascade);
    rouse();
  }

  private void rouse() {
    if (!awake) {
      awake = true;
      if (call != null) {
        call.run();
      }
    }
  }

  @Override
  public boolean awake() {
    return awake;
  }

  @Override
  public void wakeBy(@Nullable Runnable caller) {
    call = caller;
  }
}
