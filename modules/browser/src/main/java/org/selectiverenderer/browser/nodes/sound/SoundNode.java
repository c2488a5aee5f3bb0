package org.selectiverenderer.browser.nodes.sound;

import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.SleepableNode;
import org.selectiverenderer.browser.nodes.sensor.WakeState;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.browser.sound.Voice;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Sound: the position and range of an audible source (X3D 4.0, 16.4.18). It updates its source in
 * every frame, visible or not, but is audible only in visible instances, of several at the one
 * where it is loudest.
 */
public final class SoundNode extends Node implements SleepableNode {
  private final WakeState rest = new WakeState();
  private final NodeObserver rousing = (node, field) -> rest.rouse();
  private @Nullable SoundSourceNode source;
  private @Nullable Voice voice;

  public SoundNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
  }

  /** Returns the clip that is the source; empty for none. */
  public Optional<AudioClipNode> clip() {
    return node("source") instanceof AudioClipNode source ? Optional.of(source) : Optional.empty();
  }

  /** Returns the voice that is audible as of the last frame. */
  public Optional<Voice> voice() {
    return Optional.ofNullable(voice);
  }

  @Override
  public void frame(FrameContext frame, EventCascade cascade) {
    follow(node("source") instanceof SoundSourceNode played ? played : null);
    voice = null;
    if (source != null) {
      source.frame(frame, cascade);
    }
    SoundSourceNode played = source;
    if (played != null) {
      voice = played.sounding().map(recording -> heard(played, recording, frame)).orElse(null);
    }
    rest.unless(source != null && source.awake());
  }

  private void follow(@Nullable SoundSourceNode now) {
    if (now != source) {
      if (source != null) {
        source.removeObserver(rousing);
      }
      if (now != null) {
        now.addObserver(rousing);
      }
      source = now;
    }
  }

  private @Nullable Voice heard(SoundSourceNode clip, AudioBuffer recording, FrameContext frame) {
    double intensity = Math.max(0, Math.min(1, number("intensity"))) * clip.gain();
    if (!bool("enabled") || intensity == 0) {
      return null;
    }
    SpatialAudioGain best = SpatialAudioGain.NOTHING;
    SpatialAudioGain.Ellipsoids shape = shape();
    for (Matrix4dc place : frame.shownPlaces(this)) {
      SpatialAudioGain here =
          SpatialAudioGain.of(shape, place, frame.eye(), frame.orientation(), bool("spatialize"));
      best = here.gain() > best.gain() ? here : best;
    }
    double gain = intensity * best.gain();
    return gain == 0
        ? null
        : new Voice(
            this,
            recording,
            clip.position(),
            clip.rate(),
            clip.bool("loop"),
            gain * best.left(),
            gain * best.right(),
            !bool("spatialize"),
            new Voice.Rank(number("priority"), clip.elapsed(), gain));
  }

  private SpatialAudioGain.Ellipsoids shape() {
    return new SpatialAudioGain.Ellipsoids(
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
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    rest.rouse();
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
