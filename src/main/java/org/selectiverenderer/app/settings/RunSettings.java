package org.selectiverenderer.app.settings;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * The settings of a run: scene, motion, display, tracker, head log and duration.
 *
 * @param motion the viewer's motion
 * @param display the display and drawing style
 * @param tracker where the head's orientation comes from
 * @param log the head log; empty for none
 * @param duration seconds after which the run ends by itself
 */
public record RunSettings(
    SceneSettings scene,
    MotionSettings motion,
    DisplaySettings display,
    TrackerSettings tracker,
    Optional<HeadLogSettings> log,
    OptionalDouble duration) {
  /**
   * Creates the settings of a run in a window, in which the user navigates until the window is
   * closed.
   */
  public RunSettings(Path scene, SelectiveController.Settings rendering) {
    this(
        new SceneSettings(scene, rendering, ContentAccessPolicy.none(), false),
        MotionSettings.walking(MouseButtonMapping.WALK),
        DisplaySettings.WINDOW,
        TrackerSettings.NONE,
        Optional.empty(),
        OptionalDouble.empty());
  }

  /** Returns these settings with another permission to load files and URLs. */
  public RunSettings allowing(ContentAccessPolicy access) {
    return new RunSettings(
        new SceneSettings(scene.file(), scene.rendering(), access, scene.muted()),
        motion,
        display,
        tracker,
        log,
        duration);
  }

  /** Returns these settings with or without sound. */
  public RunSettings muted(boolean silent) {
    return new RunSettings(
        new SceneSettings(scene.file(), scene.rendering(), scene.access(), silent),
        motion,
        display,
        tracker,
        log,
        duration);
  }

  public RunSettings with(MotionSettings moving) {
    return new RunSettings(scene, moving, display, tracker, log, duration);
  }

  public RunSettings with(DisplaySettings shown) {
    return new RunSettings(scene, motion, shown, tracker, log, duration);
  }

  /** Returns these settings with a tracker and a head log. */
  public RunSettings with(TrackerSettings tracking, Optional<HeadLogSettings> recorded) {
    return new RunSettings(scene, motion, display, tracking, recorded, duration);
  }

  /** Returns these settings with a duration. */
  public RunSettings lasting(OptionalDouble seconds) {
    return new RunSettings(scene, motion, display, tracker, log, seconds);
  }
}
