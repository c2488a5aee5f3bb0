package org.selectiverenderer.tracker.pipeline;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Reports the problems of a tracker: each message once until records arrive again, and then that
 * they do. Used on the tracker's thread only.
 */
final class TrackerProblemReporter {
  private final TrackerSpec spec;
  private final SourceLocation location;
  private final TrackerListener listener;
  private final Set<String> said = new HashSet<>();

  TrackerProblemReporter(TrackerSpec spec, TrackerListener listener) {
    this.spec = spec;
    location = SourceLocation.of(spec.toString());
    this.listener = listener;
  }

  void lost(String sentence) {
    say(Severity.ERROR, sentence + "; the program keeps trying until it answers");
  }

  /**
   * Reports that no good record arrives.
   *
   * @param bad number of bad records since the last good one
   */
  void silent(long bad) {
    String silence = LiveTracker.seconds(TrackerHealth.SILENCE);
    say(
        Severity.ERROR,
        bad == 0
            ? "no records for " + silence + "; the last orientation is kept until records arrive"
            : "no valid records for "
                + silence
                + " ("
                + expected()
                + "); the last orientation is kept");
  }

  /** Returns a hint at what may be wrong with a device whose records are not valid. */
  private String expected() {
    if (spec instanceof TrackerSpec.Tcp) {
      return "a line must be three numbers, yaw pitch roll in degrees";
    }
    boolean serial = spec instanceof TrackerSpec.InterTrax2 || spec instanceof TrackerSpec.Fastrak;
    return serial ? "wrong speed, or another device?" : "is another program sending?";
  }

  void flood() {
    say(
        Severity.WARNING,
        "more than "
            + RecordRateGuard.LIMIT
            + " records arrive per second; all are read and the latest is used");
  }

  /** Reports that records arrive again after a problem. */
  void streaming(double pause) {
    if (!said.isEmpty()) {
      said.clear();
      say(Severity.INFO, "records arrive again, after " + LiveTracker.seconds(pause));
      said.clear();
    }
  }

  private void say(Severity severity, String sentence) {
    if (said.add(sentence)) {
      listener.problem(new Problem(severity, location, sentence));
    }
  }
}
