package org.selectiverenderer.study.web;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.session.SessionStep;

/**
 * A record of the page, checked: a step of a session that has ended.
 *
 * @param text the line's JSON, as it is kept
 * @param origin when the page was opened, by which two openings of it are told apart; empty in
 *     records of older pages
 * @param mono seconds of the page's monotonic clock at the step's begin
 * @param interruptions when the page was left and came back
 * @param repeated whether the step had been begun before, on a page that was closed
 * @param headset whether the step was shown or asked in a headset of the browser
 * @param failed whether the step is a practice that did not reach its criterion
 * @param trial what came of a trial; empty for other steps
 * @param log what an exposure or a trial logged
 */
record WebRecord(
    SourceLocation place,
    String text,
    Identity identity,
    SessionStep step,
    Instant started,
    Instant ended,
    OptionalLong origin,
    OptionalDouble mono,
    List<Interruption> interruptions,
    Map<String, String> recruitment,
    Map<String, String> device,
    List<Given> answers,
    boolean refused,
    boolean repeated,
    boolean headset,
    boolean failed,
    Optional<TrialOutcome> trial,
    Optional<WebExposureLog> log) {

  WebRecord {
    interruptions = List.copyOf(interruptions);
    answers = List.copyOf(answers);
  }

  /**
   * An outcome of a trial.
   *
   * @param phases members of the phases that were shown
   * @param listed whether the list still has the row of the stimulus, without which it is not known
   *     what was shown
   */
  record TrialOutcome(TrialResult result, List<Map<String, Object>> phases, boolean listed) {
    TrialOutcome {
      phases = List.copyOf(phases);
    }

    /** Returns when the first exposure began, in seconds since the trial did; empty for none. */
    OptionalDouble exposed() {
      return phases.stream()
          .filter(phase -> "exposure".equals(phase.get("phase")))
          .mapToDouble(phase -> (Double) phase.get("began"))
          .findFirst();
    }
  }

  /**
   * An identity is common to all records of a session.
   *
   * @param participant id of the participant in the plan
   * @param slot place in the plan, from 1
   */
  record Identity(
      String session,
      int slot,
      String participant,
      String group,
      String language,
      String checksum) {}

  /**
   * The page lost or got the focus, or left or got the full screen.
   *
   * @param t seconds since the step began
   */
  record Interruption(double t, String event) {}

  /**
   * An answer.
   *
   * @param place of the question on its page, from 1; 0 if unknown
   */
  record Given(Question question, Answer answer, OptionalLong milliseconds, int place) {}

  /** Returns the seconds from the step's begin to its end. */
  double seconds() {
    return Duration.between(started, ended).toMillis() * 1e-3;
  }

  /** Returns when the exposure began, in seconds since the step did. */
  double logBegan(WebExposureLog logged) {
    double after =
        mono.isPresent()
            ? logged.began() - mono.getAsDouble()
            : seconds() - logged.end(); // the record was made right after the last frame
    return Math.max(0, Math.min(after, seconds()));
  }

  /**
   * Returns whether the headset was left while the exposure was shown: the rest was on the page.
   */
  boolean headsetLeft(WebExposureLog logged) {
    double from = logBegan(logged);
    double to = from + logged.end();
    return headset
        && interruptions.stream()
            .anyMatch(
                one -> one.event().equals("headset-left") && one.t() >= from && one.t() <= to);
  }

  /**
   * Returns for how long the page was left while the exposure was shown, in seconds: without the
   * focus, or out of the full screen.
   */
  double secondsLeft(WebExposureLog logged) {
    double from = logBegan(logged);
    double to = from + logged.end();
    boolean blurred = false;
    boolean small = false;
    boolean off = false;
    double since = 0;
    double left = 0;
    for (Interruption one : interruptions) {
      if (blurred || small || off) {
        left += Math.max(0, Math.min(to, one.t()) - Math.max(from, since));
      }
      switch (one.event()) {
        case "blur" -> blurred = true;
        case "focus" -> blurred = false;
        case "fullscreenexit" -> small = true;
        case "fullscreenenter" -> small = false;
        case "headset-off" -> off = true;
        case "headset-on", "headset-left" -> off = false; // the rest is on the page
        default -> {
          // A newer page may tell more.
        }
      }
      since = one.t();
    }
    return left + (blurred || small || off ? Math.max(0, to - Math.max(from, since)) : 0);
  }
}
