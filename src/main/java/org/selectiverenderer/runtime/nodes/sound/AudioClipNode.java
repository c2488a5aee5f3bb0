package org.selectiverenderer.runtime.nodes.sound;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.sound.Recording;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A recording that runs in time (X3D 4.0, 16.4.2). A cycle takes as long as the recording does at
 * the clip's pitch. It is led by the Sound that it is the source of, or by the scene where it
 * stands in a group itself.
 */
public final class AudioClipNode extends PlayedNode {
  private final int pitch;
  private final int gain;
  private @Nullable Recording recording;
  private double position;

  public AudioClipNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    pitch = type.indexOf("pitch");
    gain = type.indexOf("gain");
  }

  /** Gives it a recording, or takes it away; duration_changed is sent in the next frame. */
  public void recording(@Nullable Recording found) {
    if (found != recording) {
      recording = found;
      takes(found == null ? Double.NaN : found.seconds());
    }
  }

  /** What is heard of it in this frame; empty while it does not run. */
  Optional<Recording> sounding() {
    return active() && !paused() ? Optional.ofNullable(recording) : Optional.empty();
  }

  /** Seconds from the beginning of the recording, at the recording's own rate. */
  double position() {
    return position;
  }

  /** The pitch, which makes it run faster too. */
  @Override
  double rate() {
    return (Float) value(pitch);
  }

  double gain() {
    return Math.max(0, (Float) value(gain));
  }

  @Override
  protected boolean fixedWhileActive(int field) {
    return field == pitch;
  }

  @Override
  void stands(double fraction) {
    position = recording == null ? 0 : fraction * recording.seconds();
  }
}
