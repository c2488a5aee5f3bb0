package org.selectiverenderer.app.head;

import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;

/**
 * Receives the head log's sample of every frame. It is called by the stepping thread and must not
 * block.
 */
public interface HeadSampleListener {
  /** Reports that a scene begins, to which the following samples belong. */
  void scene(HeadLogMetadata description);

  /**
   * Reports the sample of a frame.
   *
   * @param nanos {@link System#nanoTime} at the frame
   */
  void sampled(HeadSample sample, long nanos);
}
