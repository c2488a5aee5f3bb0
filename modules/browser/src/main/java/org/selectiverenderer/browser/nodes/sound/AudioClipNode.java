package org.selectiverenderer.browser.nodes.sound;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * AudioClip: plays a recording (X3D 4.0, 16.4.2). A cycle takes as long as the recording at the
 * clip's pitch. It is updated by the Sound whose source it is, or by the scene if it is the child
 * of a group.
 */
public final class AudioClipNode extends SoundSourceNode {
  private final int pitch;
  private @Nullable AudioBuffer recording;
  private double position;

  public AudioClipNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    pitch = type.indexOf("pitch");
  }

  /** Sets or removes the recording; duration_changed is sent in the next frame. */
  public void recording(@Nullable AudioBuffer found) {
    if (found != recording) {
      recording = found;
      takes(found == null ? Double.NaN : found.seconds());
    }
  }

  @Override
  Optional<AudioBuffer> sounding() {
    return active() && !paused() ? Optional.ofNullable(recording) : Optional.empty();
  }

  @Override
  double position() {
    return position;
  }

  /** Returns the pitch, which is also the factor of the playback rate. */
  @Override
  double rate() {
    return (Float) value(pitch);
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
