package org.selectiverenderer.tracker.pose;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problem;
import org.selectiverenderer.x3d.Problem.Severity;

/**
 * Says what is wrong with a tracker: each sentence once until records come again, and then that
 * they do. Used on the tracker's thread only.
 */
final class Episodes {
  private final Location location;
  private final TrackerListener listener;
  private final Set<String> said = new HashSet<>();

  Episodes(TrackerSpec spec, TrackerListener listener) {
    location = Location.of(spec.toString());
    this.listener = listener;
  }

  void lost(String sentence) {
    say(Severity.ERROR, sentence + "; it is tried again until it answers");
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
                + " makes no sense (wrong speed, or another device?); it is thrown away and the"
                + " last orientation kept");
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
