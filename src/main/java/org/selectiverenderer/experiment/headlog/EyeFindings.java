package org.selectiverenderer.experiment.headlog;

import java.util.List;
import java.util.Optional;

/**
 * What the eyes looked at, as far as the eye tracker saw them.
 *
 * @param tracked share of the time with a picture in which it saw them, 0 to 1
 * @param looks at objects
 * @param fixations in order of time
 */
public record EyeFindings(double tracked, LookSummary looks, List<Fixation> fixations) {
  /** Looks at a log; empty for one that says nothing of the eyes. */
  static Optional<EyeFindings> of(HeadLog log) {
    if (log.samples().stream().allMatch(sample -> sample.eyes() == null)) {
      return Optional.empty();
    }
    double all = 0;
    double tracked = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      EyeSample eyes = sample.eyes();
      if (sample.visible()) {
        all += log.shown(i);
        tracked += eyes != null && eyes.tracked() ? log.shown(i) : 0;
      }
    }
    return Optional.of(
        new EyeFindings(all > 0 ? tracked / all : 0, LookSummary.ofEyes(log), Fixations.of(log)));
  }

  /** The fixations of an object. */
  public List<Fixation> fixations(String object) {
    return fixations.stream().filter(each -> each.object().equals(object)).toList();
  }

  /** Their mean duration in seconds; 0 for none. */
  public double meanFixation() {
    return fixations.stream().mapToDouble(Fixation::duration).average().orElse(0);
  }
}
