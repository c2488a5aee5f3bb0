package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * Power estimated by simulation: how often simulated studies find an effect.
 *
 * @param participants number of participants of each study
 * @param studies number of simulated studies
 * @param findings the estimated power for each effect, and for equivalence
 */
public record PowerEstimate(int participants, int studies, List<Finding> findings) {
  /**
   * The share of studies with a significant result, with a 95 % interval (Wilson 1927, Journal of
   * the American Statistical Association 22).
   *
   * @param name name of the effect, or {@link PowerAnalysis#EQUIVALENCE}
   */
  public record Finding(String name, double share, double low, double high) {
    /** Returns the share of studies that found an effect. */
    public static Finding of(String name, int found, int studies) {
      double z = 1.959963984540054;
      double p = found / (double) studies;
      double scale = 1 + z * z / studies;
      double centre = (p + z * z / (2 * studies)) / scale;
      double half =
          z / scale * Math.sqrt(p * (1 - p) / studies + z * z / (4.0 * studies * studies));
      return new Finding(name, p, Math.max(0, centre - half), Math.min(1, centre + half));
    }
  }

  /** Makes defensive copies, so that the record is immutable. */
  public PowerEstimate {
    findings = List.copyOf(findings);
  }

  /**
   * Returns the estimated power of a test.
   *
   * @param name name of the tested effect
   */
  public Finding finding(String name) {
    return findings.stream()
        .filter(finding -> finding.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " is not tested"));
  }

  /** Returns the share of studies with a significant result. */
  public double share(String name) {
    return finding(name).share();
  }
}
