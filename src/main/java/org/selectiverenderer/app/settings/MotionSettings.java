package org.selectiverenderer.app.settings;

import java.util.Optional;
import org.selectiverenderer.apparatus.MouseButtonMapping;

/**
 * The settings of the viewer's motion.
 *
 * @param mouse what the mouse buttons do
 * @param path the path that the viewer follows; empty when the user navigates
 * @param viewpoint the initial viewpoint by its name or description; empty for the scene's first
 * @param collisions whether collision detection is on at first
 */
public record MotionSettings(
    MouseButtonMapping mouse,
    Optional<PathPlaybackSettings> path,
    Optional<String> viewpoint,
    boolean collisions) {
  /**
   * Creates the settings of a motion from the first viewpoint of the scene with collision
   * detection.
   */
  public MotionSettings(MouseButtonMapping mouse, Optional<PathPlaybackSettings> path) {
    this(mouse, path, Optional.empty(), true);
  }

  /** Returns these settings with another initial viewpoint. */
  public MotionSettings from(Optional<String> start) {
    return new MotionSettings(mouse, path, start, collisions);
  }

  /** Creates the settings of a motion that the user controls. */
  public static MotionSettings walking(MouseButtonMapping mouse) {
    return new MotionSettings(mouse, Optional.empty());
  }

  /** Creates the settings of a motion along a path. */
  public static MotionSettings following(PathPlaybackSettings path) {
    return new MotionSettings(MouseButtonMapping.WALK, Optional.of(path));
  }
}
