package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.head.ChainTracker;
import org.selectiverenderer.app.session.SessionShow;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.experiment.session.SessionOptions;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.open.TrackerSearch;

/**
 * Sees to it that a session's tracker works before anybody is assigned a condition.
 *
 * @param tracker stays open for the session
 */
record TrackerPresence(ChainTracker tracker, SessionShow show) {
  /** Milliseconds in which a tracker must say something: an InterTrax2's set-up takes most. */
  private static final long PATIENCE = 2_000;

  /**
   * The tracker instead of the study's: none where a session is to do without it, or where one that
   * is to be searched for does not answer; the one found by a search.
   *
   * @param without whether the session is to do without
   * @param message hears that none answers
   */
  static Optional<TrackerSpec> instead(TrackerSpec study, boolean without, Consumer<String> message)
      throws InterruptedException {
    if (study instanceof TrackerSpec.None) {
      return Optional.empty();
    }
    if (without) {
      return Optional.of(new TrackerSpec.None());
    }
    Optional<TrackerSpec> found = TrackerSearch.found(study);
    if (found.isEmpty()) {
      message.accept(
          "no tracker %s answers at a serial port; the mouse turns the view".formatted(study));
      return Optional.of(new TrackerSpec.None());
    }
    return found.filter(spec -> !spec.equals(study));
  }

  /**
   * Waits for the tracker's first record.
   *
   * @param left the steps of the session; without a scene among them no tracker is needed
   * @throws CommandFailure if it cannot be used or is silent
   */
  void require(SessionOptions options, TrackerSpec study, List<SessionStep> left)
      throws IOException, InterruptedException {
    // A headset has no records before it shows something; that it is there was seen before.
    if (show.presentation().headset().isPresent()) {
      return;
    }
    if (options.withoutTracker() || left.stream().noneMatch(SessionStep::shows)) {
      return;
    }
    try {
      tracker.awaitRecord(show.tracker(options.tracker().orElse(study)), PATIENCE);
    } catch (TrackerException e) {
      throw CommandFailure.environment(
          e.getMessage()
              + "; no step was begun. --without-tracker runs the session without it, which is"
              + " recorded");
    }
  }
}
