package org.selectiverenderer.app.session;

import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * The display settings of a session's scenes.
 *
 * @param presentation display mode and stereo geometry
 * @param tracking how the tracker's angles are taken
 * @param operator whether there is a window with what the participant sees
 * @param stage the monitors and the view of the operator
 * @param listener receives the problems of a scene
 */
public record SessionDisplaySettings(
    DisplayConfiguration presentation,
    TrackerOptions tracking,
    boolean operator,
    OperatorViewSettings stage,
    RunListener listener) {
  /** Returns the same settings with another listener. */
  public SessionDisplaySettings heardBy(RunListener other) {
    return new SessionDisplaySettings(presentation, tracking, operator, stage, other);
  }

  /**
   * Returns the settings of the tracker: while it is silent the picture freezes. A headset is its
   * own tracker.
   */
  public TrackerSettings tracker(TrackerSpec spec) {
    return new TrackerSettings(
        presentation.headset().isPresent() ? new TrackerSpec.Headset() : spec,
        tracking,
        WhenLost.FREEZE);
  }
}
