package org.selectiverenderer.app;

import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * The head's part in a run.
 *
 * @param tracker where its orientation comes from
 * @param options how the tracker's angles are taken
 * @param whenLost what turns the view while the tracker is silent
 * @param log the file of the head log; empty for none
 * @param coneDegrees width of the cone in which the log names objects
 */
public record HeadSettings(
    TrackerSpec tracker,
    TrackerOptions options,
    WhenLost whenLost,
    Optional<Path> log,
    double coneDegrees) {
  /** Degrees: about what an eye that rests looks over without turning. */
  public static final double CONE = 10;

  /** No tracker, no log. */
  public static final HeadSettings NONE =
      new HeadSettings(
          new TrackerSpec.None(), TrackerOptions.NONE, WhenLost.FREEZE, Optional.empty(), CONE);

  /** Whether there is a tracker. */
  public boolean tracked() {
    return !(tracker instanceof TrackerSpec.None);
  }
}
