package org.selectiverenderer.app.settings;

import java.util.Optional;
import org.selectiverenderer.runtime.walk.MouseMapping;

/**
 * What moves the viewer.
 *
 * @param mouse what the mouse buttons do
 * @param path that the viewer follows; empty when the user walks
 * @param viewpoint at which it begins, by its name or description; empty for the scene's first
 * @param collisions whether walls hold the user up at first
 */
public record MotionSettings(
    MouseMapping mouse,
    Optional<FollowedPath> path,
    Optional<String> viewpoint,
    boolean collisions) {
  /** From the first viewpoint of the scene, held up by walls. */
  public MotionSettings(MouseMapping mouse, Optional<FollowedPath> path) {
    this(mouse, path, Optional.empty(), true);
  }

  /** From another viewpoint. */
  public MotionSettings from(Optional<String> start) {
    return new MotionSettings(mouse, path, start, collisions);
  }

  /** The user walks. */
  public static MotionSettings walking(MouseMapping mouse) {
    return new MotionSettings(mouse, Optional.empty());
  }

  /** A path is followed. */
  public static MotionSettings following(FollowedPath path) {
    return new MotionSettings(MouseMapping.WALK, Optional.of(path));
  }
}
