package org.selectiverenderer.app.settings;

import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Where the head's orientation comes from.
 *
 * @param spec which tracker
 * @param options how the tracker's angles are taken
 * @param whenLost what turns the view while the tracker is silent
 */
public record TrackerSettings(TrackerSpec spec, TrackerOptions options, WhenLost whenLost) {
  /** No tracker. */
  public static final TrackerSettings NONE =
      new TrackerSettings(new TrackerSpec.None(), TrackerOptions.NONE, WhenLost.FREEZE);

  /** Whether there is a tracker. */
  public boolean tracked() {
    return !(spec instanceof TrackerSpec.None);
  }
}
