package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;

/**
 * The mean and standard deviation of the scores of a cell, as in Figs 92 and 96 of the thesis.
 *
 * @param within the level; empty when the design has one only
 * @param between the group; empty for all groups together ("Total")
 * @param sd standard deviation with n - 1 degrees of freedom; NaN for one participant
 * @param n number of participants
 */
public record CellDescriptives(
    Optional<String> within, Optional<String> between, double mean, double sd, int n) {
  /**
   * Returns for each within level the statistics of each group, then those of all groups together.
   */
  public static List<CellDescriptives> of(FactorialDesign design) {
    List<CellDescriptives> all = new ArrayList<>();
    for (int level = 0; level < design.within().levels().size(); level++) {
      for (int group = 0; group < design.between().levels().size(); group++) {
        all.add(
            of(
                design.group(group),
                level,
                design,
                Optional.of(design.between().levels().get(group))));
      }
      if (design.between().varies()) {
        all.add(of(design.subjects(), level, design, Optional.empty()));
      }
    }
    return all;
  }

  private static CellDescriptives of(
      List<Subject> subjects, int level, FactorialDesign design, Optional<String> between) {
    SummaryStatistics summary = new SummaryStatistics();
    subjects.forEach(subject -> summary.addValue(subject.values().get(level)));
    return new CellDescriptives(
        design.within().varies()
            ? Optional.of(design.within().levels().get(level))
            : Optional.empty(),
        between,
        summary.getMean(),
        subjects.size() < 2 ? Double.NaN : summary.getStandardDeviation(),
        subjects.size());
  }
}
