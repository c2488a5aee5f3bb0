package org.selectiverenderer.browser.nodes.sound;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.movie.MoviePlayback;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.sound.AudioBuffer;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * MovieTexture: a movie on surfaces (X3D 4.0, 18.4.2). Before it first runs it shows its first
 * frame, or its last with a negative speed; afterwards the frame with which it ended. With a speed
 * of 0 it runs for ever and shows the first frame. It is updated by the shapes and backgrounds that
 * use it, visible or not. A Sound whose source it is plays its soundtrack while it runs forwards.
 */
public final class MovieTextureNode extends SoundSourceNode {
  private final int speed;
  private @Nullable MoviePlayback film;
  private boolean hasRun;
  private @Nullable AudioBuffer soundtrack;

  /** The url to which the soundtrack belongs. */
  private String @Nullable [] soundtrackUrl;

  private double position;

  public MovieTextureNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    speed = type.indexOf("speed");
  }

  /** Sets or removes the movie; duration_changed is sent in the next frame. */
  public void film(@Nullable MoviePlayback shown) {
    if (shown != film) {
      film = shown;
      hasRun = false;
      takes(shown == null ? Double.NaN : shown.seconds());
      stand();
    }
  }

  /** Sets the soundtrack of the movie that the url names now; with another url there is none. */
  public void soundtrack(AudioBuffer found) {
    soundtrack = found;
    soundtrackUrl = strings("url");
  }

  @Override
  Optional<AudioBuffer> sounding() {
    AudioBuffer heard = soundtrack;
    boolean running = active() && !paused() && speed() > 0 && soundtrackUrl == strings("url");
    return heard != null && running && position < heard.seconds()
        ? Optional.of(heard)
        : Optional.empty();
  }

  @Override
  double position() {
    return position;
  }

  /** Returns the movie playback. */
  public Optional<MoviePlayback> film() {
    return Optional.ofNullable(film);
  }

  private float speed() {
    return (Float) value(speed);
  }

  @Override
  double rate() {
    return Math.abs(speed());
  }

  @Override
  protected boolean fixedWhileActive(int field) {
    return field == speed;
  }

  @Override
  void stands(double fraction) {
    hasRun = true;
    position = fraction * seconds();
    if (film != null) {
      film.stand((speed() < 0 ? 1 - fraction : fraction) * seconds(), speed() < 0);
    }
  }

  /** Sets the frame shown before the movie runs. */
  private void stand() {
    if (film != null) {
      film.stand(speed() < 0 ? seconds() : 0, speed() < 0);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == speed && !hasRun) {
      stand();
    }
  }
}
