package org.selectiverenderer.app.settings;

import java.util.OptionalDouble;
import org.selectiverenderer.browser.viewer.CameraPath;

/**
 * A recorded path that the viewer follows.
 *
 * @param rate frames per second of the path's time; empty for one frame per row of the path, as in
 *     the replay of a session
 */
public record PathPlaybackSettings(CameraPath path, OptionalDouble rate) {
  /** The frame rate of a path that the command {@code run} follows, in frames per second. */
  public static final double RATE = 60;

  /** Creates a path with frames at a fixed rate. */
  public static PathPlaybackSettings at(double rate, CameraPath path) {
    return new PathPlaybackSettings(path, OptionalDouble.of(rate));
  }

  /** Creates a path with one frame per row, for a recorded session. */
  public static PathPlaybackSettings rows(CameraPath path) {
    return new PathPlaybackSettings(path, OptionalDouble.empty());
  }
}
