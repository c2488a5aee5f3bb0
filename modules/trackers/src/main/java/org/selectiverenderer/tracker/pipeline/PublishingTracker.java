package org.selectiverenderer.tracker.pipeline;

import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Base class of trackers that publish poses; readers get the latest one, relative to the boresight.
 */
public abstract class PublishingTracker implements HeadTracker {
  private final TrackerSpec spec;
  private final LatestPose newest = new LatestPose();
  private final Boresight boresight = new Boresight(newest);

  protected PublishingTracker(TrackerSpec spec) {
    this.spec = spec;
  }

  /** Publishes a pose; called by one thread. */
  protected final void publish(PoseSample sample) {
    boresight.arriving(sample);
    newest.publish(sample);
  }

  /** Makes the heading of the next published pose yaw 0. */
  protected final void straightenNext() {
    boresight.resetAtNext();
  }

  @Override
  public final TrackerSpec spec() {
    return spec;
  }

  @Override
  public final boolean read(PoseSample into) {
    return boresight.read(into);
  }

  @Override
  public final void resetHeading() {
    boresight.reset();
  }
}
