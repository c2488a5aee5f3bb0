package org.selectiverenderer.app.session;

import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * How a session's scenes are shown.
 *
 * @param presentation to one eye or two, and on what
 * @param tracking how the tracker's angles are taken
 * @param operator whether there is a window with what the participant sees
 * @param stage what the operator has and sees
 * @param listener hears what is wrong with a scene
 */
public record SessionShow(
    Presentation presentation,
    TrackerOptions tracking,
    boolean operator,
    SessionStage stage,
    RunListener listener) {
  /** The same with another listener. */
  public SessionShow heardBy(RunListener other) {
    return new SessionShow(presentation, tracking, operator, stage, other);
  }

  /** How a tracker is taken: while it is silent the picture stays as it is. A headset is one. */
  public TrackerSettings tracker(TrackerSpec spec) {
    return new TrackerSettings(
        presentation.headset().isPresent() ? new TrackerSpec.Headset() : spec,
        tracking,
        WhenLost.FREEZE);
  }
}
