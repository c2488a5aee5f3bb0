package org.selectiverenderer.experiment.headlog;

import java.util.List;
import java.util.Optional;

/**
 * What a head log says about a session. Only samples that the participant saw count: what lies in
 * the middle of a view that is black is not looked at.
 *
 * @param seconds in which there was a picture
 * @param unshown what is left out
 * @param idle share of the time in which the head did not move, 0 to 1
 * @param head what was in the middle of the view
 * @param eyes what the eyes looked at; empty for a log that does not say
 */
public record HeadLogAnalysis(
    HeadLog log,
    double seconds,
    Unshown unshown,
    double idle,
    LookSummary head,
    Optional<EyeFindings> eyes,
    List<RoomView> rooms) {

  /**
   * What a log has beside what the participant saw.
   *
   * @param samples without a picture
   * @param seconds that these last
   * @param pauses how often time stood still for the session
   * @param paused seconds that these pauses last together, which the log's time does not count
   */
  public record Unshown(int samples, double seconds, int pauses, double paused) {}

  /** Looks at a log. */
  public static HeadLogAnalysis of(HeadLog log) {
    double idle = 0;
    double all = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      if (log.samples().get(i).visible()) {
        all += log.shown(i);
        idle += log.samples().get(i).moved() ? 0 : log.shown(i);
      }
    }
    return new HeadLogAnalysis(
        log,
        all,
        unshown(log),
        all > 0 ? idle / all : 0,
        LookSummary.ofHead(log),
        EyeFindings.of(log),
        log.description().map().rooms().stream().map(room -> RoomView.of(room, log)).toList());
  }

  private static Unshown unshown(HeadLog log) {
    int samples = 0;
    double seconds = 0;
    int pauses = 0;
    double paused = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      if (!log.samples().get(i).visible()) {
        samples++;
        seconds += log.shown(i);
      }
      double pause = log.pauseBefore(i);
      if (pause > 0) {
        pauses++;
        paused += pause;
      }
    }
    return new Unshown(samples, seconds, pauses, paused);
  }
}
