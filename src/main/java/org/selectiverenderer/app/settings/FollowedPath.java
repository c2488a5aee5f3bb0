package org.selectiverenderer.app.settings;

import java.util.OptionalDouble;
import org.selectiverenderer.runtime.viewer.CameraPath;

/**
 * A recorded path that the viewer follows.
 *
 * @param rate frames per second of the path's time; empty for frames that are the path's own rows,
 *     as those of a session played again
 */
public record FollowedPath(CameraPath path, OptionalDouble rate) {
  /** Frames per second of a path that {@code run} follows. */
  public static final double RATE = 60;

  /** Frames at equal distances. */
  public static FollowedPath at(double rate, CameraPath path) {
    return new FollowedPath(path, OptionalDouble.of(rate));
  }

  /** The frames of a session that was recorded. */
  public static FollowedPath rows(CameraPath path) {
    return new FollowedPath(path, OptionalDouble.empty());
  }
}
