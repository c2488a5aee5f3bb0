package org.selectiverenderer.app.settings;

import java.util.Optional;
import org.selectiverenderer.runtime.walk.MouseMapping;

/**
 * What moves the viewer.
 *
 * @param mouse what the mouse buttons do
 * @param path that the viewer follows; empty when the user walks
 */
public record MotionSettings(MouseMapping mouse, Optional<FollowedPath> path) {
  /** The user walks. */
  public static MotionSettings walking(MouseMapping mouse) {
    return new MotionSettings(mouse, Optional.empty());
  }

  /** A path is followed. */
  public static MotionSettings following(FollowedPath path) {
    return new MotionSettings(MouseMapping.WALK, Optional.of(path));
  }
}
