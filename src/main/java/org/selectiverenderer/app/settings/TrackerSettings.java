package org.selectiverenderer.app.settings;

import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Where the head's orientation and place come from.
 *
 * @param spec which tracker
 * @param options how the tracker's angles are taken
 * @param whenLost what turns the view while the tracker is silent
 * @param placed whether the place of the head is used, where the tracker tells it
 */
public record TrackerSettings(
    TrackerSpec spec, TrackerOptions options, WhenLost whenLost, boolean placed) {
  /** Which only turns the head. */
  public TrackerSettings(TrackerSpec spec, TrackerOptions options, WhenLost whenLost) {
    this(spec, options, whenLost, false);
  }

  /** No tracker. */
  public static final TrackerSettings NONE =
      new TrackerSettings(new TrackerSpec.None(), TrackerOptions.NONE, WhenLost.FREEZE);

  /** Whether there is a tracker. */
  public boolean tracked() {
    return !(spec instanceof TrackerSpec.None);
  }
}
