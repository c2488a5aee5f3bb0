package org.selectiverenderer.app.head;

import org.selectiverenderer.experiment.headlog.HeadLogDescription;
import org.selectiverenderer.experiment.headlog.HeadSample;

/** Hears of every frame what a head log has of it. Called by the stepping thread; must not wait. */
public interface SampleListener {
  /** A scene begins; the samples that follow are of it. */
  void scene(HeadLogDescription description);

  /**
   * A frame was stepped.
   *
   * @param nanos {@link System#nanoTime} of the frame
   */
  void sampled(HeadSample sample, long nanos);
}
