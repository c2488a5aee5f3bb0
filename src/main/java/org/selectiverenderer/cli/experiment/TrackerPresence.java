package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.List;
import org.selectiverenderer.app.head.ChainTracker;
import org.selectiverenderer.app.session.SessionShow;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.experiment.session.SessionOptions;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Sees to it that a session's tracker works before anybody is assigned a condition.
 *
 * @param tracker stays open for the session
 */
record TrackerPresence(ChainTracker tracker, SessionShow show) {
  /** Milliseconds in which a tracker must say something: an InterTrax2's set-up takes most. */
  private static final long PATIENCE = 2_000;

  /**
   * Waits for the tracker's first record.
   *
   * @param left the steps of the session; without a scene among them no tracker is needed
   * @throws CommandFailure if it cannot be used or is silent
   */
  void require(SessionOptions options, TrackerSpec spec, List<SessionStep> left)
      throws IOException, InterruptedException {
    boolean shown =
        left.stream()
            .anyMatch(
                step ->
                    step instanceof SessionStep.Practice || step instanceof SessionStep.Exposure);
    if (options.withoutTracker() || !shown) {
      return;
    }
    try {
      tracker.awaitRecord(show.tracker(spec), PATIENCE);
    } catch (TrackerException e) {
      throw CommandFailure.environment(
          e.getMessage()
              + "; nobody was assigned a condition. --without-tracker runs the session without"
              + " it, which is recorded");
    }
  }
}
