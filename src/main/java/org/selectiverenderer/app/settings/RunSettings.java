package org.selectiverenderer.app.settings;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.runtime.walk.MouseMapping;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * What a run shows and for how long: a scene that is walked through in a window, and what differs
 * from that.
 *
 * @param motion what moves the viewer
 * @param display on what it is shown
 * @param tracker where the head's orientation comes from
 * @param log what is recorded of the head; empty for nothing
 * @param duration seconds after which the run ends by itself
 */
public record RunSettings(
    SceneSettings scene,
    MotionSettings motion,
    DisplaySettings display,
    TrackerSettings tracker,
    Optional<HeadLogSettings> log,
    OptionalDouble duration) {
  /** A scene that the user walks through in a window, until he closes it. */
  public RunSettings(Path scene, SelectiveController.Settings rendering) {
    this(
        new SceneSettings(scene, rendering, ContentAccess.none(), false),
        MotionSettings.walking(MouseMapping.WALK),
        DisplaySettings.WINDOW,
        TrackerSettings.NONE,
        Optional.empty(),
        OptionalDouble.empty());
  }

  /** Of a scene that may name more than its own files. */
  public RunSettings allowing(ContentAccess access) {
    return new RunSettings(
        new SceneSettings(scene.file(), scene.rendering(), access, scene.muted()),
        motion,
        display,
        tracker,
        log,
        duration);
  }

  /** Whose sounds are heard, or not. */
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

  /** With a tracker, and what is recorded of the head. */
  public RunSettings with(TrackerSettings tracking, Optional<HeadLogSettings> recorded) {
    return new RunSettings(scene, motion, display, tracking, recorded, duration);
  }

  /** That ends by itself. */
  public RunSettings lasting(OptionalDouble seconds) {
    return new RunSettings(scene, motion, display, tracker, log, seconds);
  }
}
