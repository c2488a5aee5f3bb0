package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.session.SessionDisplaySettings;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.InterTrax2PortFinder;

/**
 * Checks that a session's tracker works before the participant is assigned a condition.
 *
 * @param tracker the tracker, which stays open for the session
 */
record TrackerReadinessCheck(SharedHeadTracker tracker, SessionDisplaySettings show) {
  /**
   * The time in milliseconds within which a tracker must send a sample; most of it is the set-up of
   * an InterTrax2.
   */
  private static final long PATIENCE = 2_000;

  /**
   * Returns the tracker that replaces the study's: none where the session runs without a tracker or
   * where a searched tracker does not answer; or the one that a search found.
   *
   * @param without whether the session runs without a tracker
   * @param message receives a message when no tracker answers
   */
  static Optional<TrackerSpec> instead(TrackerSpec study, boolean without, Consumer<String> message)
      throws InterruptedException {
    if (study instanceof TrackerSpec.None) {
      return Optional.empty();
    }
    if (without) {
      return Optional.of(new TrackerSpec.None());
    }
    Optional<TrackerSpec> found = InterTrax2PortFinder.found(study);
    if (found.isEmpty()) {
      message.accept(
          "no tracker %s answers at a serial port; the mouse turns the view".formatted(study));
      return Optional.of(new TrackerSpec.None());
    }
    return found.filter(spec -> !spec.equals(study));
  }

  /**
   * Waits for the tracker's first sample.
   *
   * @param left the remaining steps of the session; without a scene among them no tracker is needed
   * @throws CommandException if the tracker cannot be used or is silent
   */
  void require(SessionOptions options, TrackerSpec study, List<SessionStep> left)
      throws IOException, InterruptedException {
    // A headset sends no samples before it shows a picture; its presence was checked before.
    if (show.presentation().headset().isPresent()) {
      return;
    }
    if (options.withoutTracker() || left.stream().noneMatch(SessionStep::shows)) {
      return;
    }
    try {
      tracker.awaitRecord(show.tracker(options.tracker().orElse(study)), PATIENCE);
    } catch (TrackerException e) {
      throw CommandException.environment(
          e.getMessage()
              + "; no step was begun. --without-tracker runs the session without it, which is"
              + " recorded");
    }
  }
}
