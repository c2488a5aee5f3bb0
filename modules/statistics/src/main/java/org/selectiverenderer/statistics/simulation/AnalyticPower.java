package org.selectiverenderer.statistics.simulation;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.FDistribution;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.distribution.NoncentralF;
import org.selectiverenderer.statistics.study.AreaAnalyser;

/**
 * Computes power analytically by the noncentral F distribution, from the exact moments of the
 * scores (Cohen 1988, Statistical Power Analysis, chapter 8; Maxwell and Delaney 2004, Designing
 * Experiments, chapters 3 and 12). It assumes normal scores and equal variances of the groups; the
 * simulation, which does not, is reported beside it.
 */
public final class AnalyticPower {
  private static final double[] ONE = {1};
  private static final double[] MEAN = {0.5, 0.5};
  private static final double[] DIFFERENCE = {-1, 1};

  private final List<ScoreMoments> groups;
  private final int[] sizes;
  private final int participants;
  private final double alpha;

  private AnalyticPower(List<ScoreMoments> groups, int participants, double alpha) {
    this.groups = groups;
    this.participants = participants;
    this.alpha = alpha;
    sizes =
        IntStream.range(0, groups.size())
            .map(group -> (participants - group + groups.size() - 1) / groups.size())
            .toArray();
  }

  /**
   * Returns the power for each effect that the analysis tests, by its name; equivalence has no such
   * formula. The map is empty where a score may be infinite, or an area has more than two types.
   *
   * @param participants number of participants, assigned to the conditions in turn; greater than
   *     that of conditions
   */
  public static Map<String, Double> of(PowerAnalysis analysis, int participants) {
    SimulationModel model = analysis.model().of(analysis.area());
    Map<String, Double> powers = new LinkedHashMap<>();
    if (analysis.scoring().correction() == ExtremeRateCorrection.NONE || model.lists().size() > 2) {
      return powers;
    }
    AnalyticPower formula =
        new AnalyticPower(
            IntStream.range(0, model.conditions().size())
                .mapToObj(
                    group ->
                        ScoreMoments.of(
                            model, group, analysis.measure(), analysis.scoring().correction()))
                .toList(),
            participants,
            analysis.options().alpha());
    boolean types = model.lists().size() > 1;
    if (model.conditions().size() > 1) {
      powers.put(AreaAnalyser.BETWEEN, formula.between(types ? MEAN : ONE));
    }
    if (types) {
      powers.put(AreaAnalyser.WITHIN, formula.within());
    }
    if (types && model.conditions().size() > 1) {
      powers.put(AreaAnalyser.WITHIN + " x " + AreaAnalyser.BETWEEN, formula.between(DIFFERENCE));
    }
    return powers;
  }

  /** Returns the power for differences between groups in a weighted sum of the scores. */
  private double between(double... weights) {
    double mean = 0;
    for (int group = 0; group < sizes.length; group++) {
      mean += sizes[group] * groups.get(group).mean(weights) / participants;
    }
    double between = 0;
    for (int group = 0; group < sizes.length; group++) {
      between += sizes[group] * Math.pow(groups.get(group).mean(weights) - mean, 2);
    }
    return power(sizes.length - 1, between / error(weights));
  }

  /**
   * Returns the power for a difference between the types, over groups with equal weights (type
   * III).
   */
  private double within() {
    double difference = 0;
    double inverse = 0;
    for (int group = 0; group < sizes.length; group++) {
      difference += groups.get(group).mean(DIFFERENCE) / sizes.length;
      inverse += 1.0 / sizes[group] / sizes.length / sizes.length;
    }
    return power(1, difference * difference / (error(DIFFERENCE) * inverse));
  }

  private double error(double... weights) {
    double sum = 0;
    for (int group = 0; group < sizes.length; group++) {
      sum += (sizes[group] - 1) * groups.get(group).variance(weights);
    }
    return sum / (participants - sizes.length);
  }

  private double power(int df1, double noncentrality) {
    int df2 = participants - sizes.length;
    double critical = new FDistribution(null, df1, df2).inverseCumulativeProbability(1 - alpha);
    return 1 - new NoncentralF(df1, df2).cumulative(critical, noncentrality);
  }
}
