package org.selectiverenderer.statistics.detection;

import java.util.Optional;
import org.apache.commons.math3.distribution.NormalDistribution;

/**
 * Sensitivity and bias of the equal-variance model (Wickens 2001, Elementary Signal Detection
 * Theory; Macmillan and Creelman 2005, chapters 1 and 2; thesis 6.4).
 *
 * @param hitRate corrected; not a number without answers to present objects
 * @param falseAlarmRate corrected; not a number without answers to absent objects
 * @param dPrime z(H) - z(F): how well present and absent objects are told apart
 * @param logBeta ln(phi(z(H)) / phi(z(F))) = (z(F)² - z(H)²) / 2: above 0 a bias towards "no"
 * @param criterion -(z(H) + z(F)) / 2: above 0 a bias towards "no"
 * @param flaw why something is not a number: a sentence without its full stop
 */
public record Detection(
    double hitRate,
    double falseAlarmRate,
    double dPrime,
    double logBeta,
    double criterion,
    Optional<String> flaw) {
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /** From counts. */
  public static Detection of(ResponseCounts counts, Correction correction) {
    double hit = rate(counts.hits(), counts.signals(), correction);
    double falseAlarm = rate(counts.falseAlarms(), counts.noise(), correction);
    if (counts.signals() == 0 || counts.noise() == 0) {
      return undefined(
          hit,
          falseAlarm,
          "no answers to %s objects are left"
              .formatted(
                  counts.signals() > 0
                      ? "absent"
                      : counts.noise() > 0 ? "present" : "present and to absent"));
    }
    if (hit == 0 || hit == 1 || falseAlarm == 0 || falseAlarm == 1) {
      return undefined(hit, falseAlarm, "a rate of 0 or 1 was not corrected, so its z is infinite");
    }
    double zHit = NORMAL.inverseCumulativeProbability(hit);
    double zFalseAlarm = NORMAL.inverseCumulativeProbability(falseAlarm);
    return new Detection(
        hit,
        falseAlarm,
        zHit - zFalseAlarm,
        (zFalseAlarm * zFalseAlarm - zHit * zHit) / 2,
        -(zHit + zFalseAlarm) / 2,
        Optional.empty());
  }

  private static double rate(int count, int total, Correction correction) {
    return total == 0 ? Double.NaN : correction.rate(count, total);
  }

  private static Detection undefined(double hit, double falseAlarm, String flaw) {
    return new Detection(hit, falseAlarm, Double.NaN, Double.NaN, Double.NaN, Optional.of(flaw));
  }
}
