package org.selectiverenderer.tracker;

import org.selectiverenderer.base.problem.Problem;

/** Receives the events of a tracker on its thread; must return quickly. */
public interface TrackerListener {
  /**
   * A good record arrived; {@link TrackerOptions} are applied, the boresight is not.
   *
   * @param sample the record; reused for the next one
   */
  default void sample(PoseSample sample) {}

  /**
   * A problem for the user to know; reported once when it begins, not for every record. ERROR if
   * the tracker cannot be used now, INFO when it can be used again.
   */
  void problem(Problem problem);
}
