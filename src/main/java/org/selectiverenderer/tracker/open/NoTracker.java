package org.selectiverenderer.tracker.open;

import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerSpec;

/** The null object for {@code none}: a tracker that never has a pose or a problem. */
final class NoTracker implements HeadTracker {
  @Override
  public TrackerSpec spec() {
    return new TrackerSpec.None();
  }

  @Override
  public boolean read(PoseSample into) {
    return false;
  }

  @Override
  public void resetHeading() {}

  @Override
  public TrackerHealth health() {
    return new TrackerHealth(TrackerHealth.State.NONE, 0, 0, 0, 0, 0, 0, 0);
  }

  @Override
  public void close() {}
}
