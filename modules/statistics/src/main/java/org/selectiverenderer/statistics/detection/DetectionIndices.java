package org.selectiverenderer.statistics.detection;

import java.util.Optional;
import org.apache.commons.math3.distribution.NormalDistribution;

/**
 * Indices of sensitivity and bias: those of the equal-variance signal detection model (Wickens
 * 2001, Elementary Signal Detection Theory; Macmillan and Creelman 2005, chapters 1 and 2; thesis
 * 6.4).
 *
 * @param hitRate corrected hit rate; NaN without answers to present objects
 * @param falseAlarmRate corrected false-alarm rate; NaN without answers to absent objects
 * @param dPrime z(H) - z(F): how well present and absent objects are told apart
 * @param logBeta ln(phi(z(H)) / phi(z(F))) = (z(F)² - z(H)²) / 2: above 0 a bias towards "no"
 * @param criterion -(z(H) + z(F)) / 2: above 0 a bias towards "no"
 * @param aPrime A': the area under the ROC estimated from one point, from uncorrected rates
 *     (Pollack and Norman 1964, Psychonomic Science 1; below chance as in Snodgrass and Corwin
 *     1988, Journal of Experimental Psychology: General 117); 0.5 is chance
 * @param bDoublePrime B'': the index of bias that belongs to A' (Grier 1971, Psychological Bulletin
 *     75; Snodgrass and Corwin 1988): above 0 a bias towards "no"; NaN where both rates are 0 or 1
 * @param flaw why d', log beta and c are NaN, as a sentence without its full stop
 */
public record DetectionIndices(
    double hitRate,
    double falseAlarmRate,
    double dPrime,
    double logBeta,
    double criterion,
    double aPrime,
    double bDoublePrime,
    Optional<String> flaw) {
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /** Computes the indices from counts of answers. */
  public static DetectionIndices of(ResponseCounts counts, ExtremeRateCorrection correction) {
    double hit = rate(counts.hits(), counts.signals(), correction);
    double falseAlarm = rate(counts.falseAlarms(), counts.noise(), correction);
    if (counts.signals() == 0 || counts.noise() == 0) {
      return undefined(
          counts,
          hit,
          falseAlarm,
          "no answers to %s objects are left"
              .formatted(
                  counts.signals() > 0
                      ? "absent"
                      : counts.noise() > 0 ? "present" : "present and to absent"));
    }
    if (hit == 0 || hit == 1 || falseAlarm == 0 || falseAlarm == 1) {
      return undefined(
          counts, hit, falseAlarm, "a rate of 0 or 1 was not corrected, so its z is infinite");
    }
    double zHit = NORMAL.inverseCumulativeProbability(hit);
    double zFalseAlarm = NORMAL.inverseCumulativeProbability(falseAlarm);
    return new DetectionIndices(
        hit,
        falseAlarm,
        zHit - zFalseAlarm,
        (zFalseAlarm * zFalseAlarm - zHit * zHit) / 2,
        -(zHit + zFalseAlarm) / 2,
        aPrime(counts),
        bDoublePrime(counts),
        Optional.empty());
  }

  private static double rate(int count, int total, ExtremeRateCorrection correction) {
    return total == 0 ? Double.NaN : correction.rate(count, total);
  }

  private static DetectionIndices undefined(
      ResponseCounts counts, double hit, double falseAlarm, String flaw) {
    return new DetectionIndices(
        hit,
        falseAlarm,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        aPrime(counts),
        bDoublePrime(counts),
        Optional.of(flaw));
  }

  /** Returns A'; NaN without answers to both present and absent objects. */
  private static double aPrime(ResponseCounts counts) {
    double hit = rate(counts.hits(), counts.signals(), ExtremeRateCorrection.NONE);
    double falseAlarm = rate(counts.falseAlarms(), counts.noise(), ExtremeRateCorrection.NONE);
    if (hit == falseAlarm) {
      return 0.5;
    }
    double large = Math.max(hit, falseAlarm);
    double small = Math.min(hit, falseAlarm);
    double beyondChance = (large - small) * (1 + large - small) / (4 * large * (1 - small));
    return hit > falseAlarm ? 0.5 + beyondChance : 0.5 - beyondChance;
  }

  private static double bDoublePrime(ResponseCounts counts) {
    double hit = rate(counts.hits(), counts.signals(), ExtremeRateCorrection.NONE);
    double falseAlarm = rate(counts.falseAlarms(), counts.noise(), ExtremeRateCorrection.NONE);
    double hitSpread = hit * (1 - hit);
    double falseAlarmSpread = falseAlarm * (1 - falseAlarm);
    double bias = (hitSpread - falseAlarmSpread) / (hitSpread + falseAlarmSpread);
    return hit >= falseAlarm ? bias : -bias;
  }
}
