package org.selectiverenderer.study.headlog;

import java.util.List;
import java.util.Optional;

/**
 * The analysis of a head log. Only the time in view counts: nobody looks at an object in the middle
 * of a black view. It is the time with a visible picture, pauses left out, within the limits of the
 * log ({@link HeadLog#inView(double, double)}).
 *
 * @param seconds total time in view
 * @param unshown samples and pauses that are left out
 * @param idle share of that time in which the head did not move, 0 to 1
 * @param head dwells of objects in the middle of the view
 * @param eyes analysis of the gaze data; empty for a log without
 */
public record HeadLogAnalysis(
    HeadLog log,
    double seconds,
    Unshown unshown,
    double idle,
    DwellSummary head,
    Optional<EyeTrackingAnalysis> eyes,
    List<RoomCoverage> rooms) {

  /**
   * Time of a log that does not count: without a visible picture, or paused.
   *
   * @param samples number of samples without a picture
   * @param seconds total duration of these samples
   * @param pauses number of pauses
   * @param paused total duration of the pauses in seconds, which the log's time does not include
   */
  public record Unshown(int samples, double seconds, int pauses, double paused) {}

  /** Analyses a log. */
  public static HeadLogAnalysis of(HeadLog log) {
    double idle = 0;
    double all = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      if (log.inView(i)) {
        all += log.shown(i);
        idle += log.samples().get(i).moved() ? 0 : log.shown(i);
      }
    }
    return new HeadLogAnalysis(
        log,
        all,
        unshown(log),
        all > 0 ? idle / all : 0,
        DwellSummary.ofHead(log),
        EyeTrackingAnalysis.of(log),
        log.description().map().rooms().stream().map(room -> RoomCoverage.of(room, log)).toList());
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
