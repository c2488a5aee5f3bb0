package org.selectiverenderer.runtime.nodes.sound;

import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.nodes.sensor.Frame;
import org.selectiverenderer.runtime.nodes.sensor.Sleeper;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeObserver;
import org.selectiverenderer.runtime.sound.Recording;
import org.selectiverenderer.runtime.sound.Voice;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Where a clip is heard (X3D 4.0, 16.4.18). It leads its clip through the frames, shown or not; it
 * is heard only where it is shown, and of several places at the one where it is loudest. A
 * MovieTexture as its source is silent.
 */
public final class SoundNode extends Node implements Sleeper {
  private final NodeObserver rousing = (node, field) -> rouse();
  private @Nullable AudioClipNode clip;
  private @Nullable Voice voice;
  private boolean awake = true;
  private @Nullable Runnable call;

  public SoundNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
  }

  /** The clip that it plays; empty for none. */
  public Optional<AudioClipNode> clip() {
    return node("source") instanceof AudioClipNode source ? Optional.of(source) : Optional.empty();
  }

  /** What is heard of it as of the last frame. */
  public Optional<Voice> voice() {
    return Optional.ofNullable(voice);
  }

  @Override
  public void frame(Frame frame, Cascade cascade) {
    follow(clip().orElse(null));
    voice = null;
    if (clip != null) {
      clip.frame(frame, cascade);
      voice = clip.sounding().map(recording -> heard(clip, recording, frame)).orElse(null);
    }
    awake = clip != null && clip.awake();
  }

  private void follow(@Nullable AudioClipNode source) {
    if (source != clip) {
      if (clip != null) {
        clip.removeObserver(rousing);
      }
      if (source != null) {
        source.addObserver(rousing);
      }
      clip = source;
    }
  }

  private @Nullable Voice heard(AudioClipNode clip, Recording recording, Frame frame) {
    double intensity = Math.max(0, Math.min(1, number("intensity"))) * clip.gain();
    if (!bool("enabled") || intensity == 0) {
      return null;
    }
    Hearing best = Hearing.NOTHING;
    Hearing.Ellipsoids shape = shape();
    for (Matrix4dc place : frame.shownPlaces(this)) {
      Hearing here = Hearing.of(shape, place, frame.eye(), frame.orientation(), bool("spatialize"));
      best = here.gain() > best.gain() ? here : best;
    }
    double gain = intensity * best.gain();
    return gain == 0
        ? null
        : new Voice(
            this,
            recording,
            clip.position(),
            clip.pitch(),
            clip.bool("loop"),
            gain * best.left(),
            gain * best.right(),
            !bool("spatialize"),
            new Voice.Rank(number("priority"), clip.elapsed(), gain));
  }

  private Hearing.Ellipsoids shape() {
    return new Hearing.Ellipsoids(
        vector("location"),
        vector("direction"),
        distance("minFront"),
        distance("minBack"),
        distance("maxFront"),
        distance("maxBack"));
  }

  private Vector3d vector(String field) {
    float[] v = floats(field);
    return new Vector3d(v[0], v[1], v[2]);
  }

  private double distance(String field) {
    return Math.max(0, number(field));
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
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
