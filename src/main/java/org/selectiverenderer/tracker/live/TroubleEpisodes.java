package org.selectiverenderer.tracker.live;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * Says what is wrong with a tracker: each sentence once until records come again, and then that
 * they do. Used on the tracker's thread only.
 */
final class TroubleEpisodes {
  private final TrackerSpec spec;
  private final Location location;
  private final TrackerListener listener;
  private final Set<String> said = new HashSet<>();

  TroubleEpisodes(TrackerSpec spec, TrackerListener listener) {
    this.spec = spec;
    location = Location.of(spec.toString());
    this.listener = listener;
  }

  void lost(String sentence) {
    say(Severity.ERROR, sentence + "; the program keeps trying until it answers");
  }

  /**
   * @param bad records since the last good one
   */
  void silent(long bad) {
    String silence = LiveTracker.seconds(TrackerHealth.SILENCE);
    say(
        Severity.ERROR,
        bad == 0
            ? "nothing came for " + silence + "; the last orientation is kept until records come"
            : "what came for "
                + silence
                + " cannot be understood ("
                + expected()
                + "); it is ignored and the last orientation is kept");
  }

  /** What may be wrong with a sender that is not understood. */
  private String expected() {
    if (spec instanceof TrackerSpec.Tcp) {
      return "a line must be three numbers, yaw pitch roll in degrees";
    }
    boolean serial = spec instanceof TrackerSpec.InterTrax2 || spec instanceof TrackerSpec.Fastrak;
    return serial ? "wrong speed, or another device?" : "another program?";
  }

  void flood() {
    say(
        Severity.WARNING,
        "more than "
            + FloodGuard.LIMIT
            + " records come per second; all are read and the newest is used");
  }

  /** Records come, perhaps again. */
  void streaming(double pause) {
    if (!said.isEmpty()) {
      said.clear();
      say(Severity.INFO, "records come again, after " + LiveTracker.seconds(pause));
      said.clear();
    }
  }

  private void say(Severity severity, String sentence) {
    if (said.add(sentence)) {
      listener.problem(new Problem(severity, location, sentence));
    }
  }
}
