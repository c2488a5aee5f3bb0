package org.selectiverenderer.app.settings;

import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * The settings of the head tracker.
 *
 * @param spec the tracker
 * @param options how the tracker's angles are taken
 * @param whenLost what turns the view while the tracker is silent
 * @param placed whether the position of the head is used, where the tracker reports it
 */
public record TrackerSettings(
    TrackerSpec spec, TrackerOptions options, WhenLost whenLost, boolean placed) {
  /** Creates the settings of a tracker of which only the orientation is used. */
  public TrackerSettings(TrackerSpec spec, TrackerOptions options, WhenLost whenLost) {
    this(spec, options, whenLost, false);
  }

  /** No tracker. */
  public static final TrackerSettings NONE =
      new TrackerSettings(new TrackerSpec.None(), TrackerOptions.NONE, WhenLost.FREEZE);

  /** Returns whether there is a tracker. */
  public boolean tracked() {
    return !(spec instanceof TrackerSpec.None);
  }
}
