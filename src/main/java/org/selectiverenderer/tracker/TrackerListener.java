package org.selectiverenderer.tracker;

import org.selectiverenderer.base.problem.Problem;

/** Hears what happens on a tracker's thread; must return soon. */
public interface TrackerListener {
  /**
   * A good record, after {@link TrackerOptions} and before the boresight.
   *
   * @param sample is used again for the next record
   */
  default void sample(PoseSample sample) {}

  /**
   * Something that the user should know; once each time that it begins, not for every record. ERROR
   * for a tracker that cannot be used now, INFO when it can be again.
   */
  void problem(Problem problem);
}
