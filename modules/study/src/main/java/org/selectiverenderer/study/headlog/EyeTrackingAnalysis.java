package org.selectiverenderer.study.headlog;

import java.util.List;
import java.util.Optional;

/**
 * The analysis of a log's gaze data: tracking ratio, dwells and fixations.
 *
 * @param tracked share of the time in view in which the eyes were tracked, 0 to 1
 * @param looks the dwells of the gaze on objects
 * @param fixations all fixations in order of time
 */
public record EyeTrackingAnalysis(double tracked, DwellSummary looks, List<Fixation> fixations) {
  /** Analyses a log; empty for a log without gaze data. */
  public static Optional<EyeTrackingAnalysis> of(HeadLog log) {
    if (log.samples().stream().allMatch(sample -> sample.eyes() == null)) {
      return Optional.empty();
    }
    double all = 0;
    double tracked = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      EyeSample eyes = sample.eyes();
      if (log.inView(i)) {
        all += log.shown(i);
        tracked += eyes != null && eyes.tracked() ? log.shown(i) : 0;
      }
    }
    return Optional.of(
        new EyeTrackingAnalysis(
            all > 0 ? tracked / all : 0, DwellSummary.ofEyes(log), FixationDetector.of(log)));
  }

  /** Returns the fixations on an object. */
  public List<Fixation> fixations(String object) {
    return fixations.stream().filter(each -> each.object().equals(object)).toList();
  }

  /** Returns the mean duration of all fixations in seconds; 0 if there is none. */
  public double meanFixation() {
    return fixations.stream().mapToDouble(Fixation::duration).average().orElse(0);
  }
}
