package org.selectiverenderer.statistics.simulation;

import java.util.List;

/**
 * How often simulated studies find what they look for.
 *
 * @param participants of each study
 * @param studies simulated
 * @param findings for each effect, and for equivalence
 */
public record Power(int participants, int studies, List<Finding> findings) {
  /**
   * The share of studies that find something, with a 95 % interval (Wilson 1927, Journal of the
   * American Statistical Association 22).
   *
   * @param name an effect's, or {@link PowerAnalysis#EQUIVALENCE}
   */
  public record Finding(String name, double share, double low, double high) {
    static Finding of(String name, int found, int studies) {
      double z = 1.959963984540054;
      double p = found / (double) studies;
      double scale = 1 + z * z / studies;
      double centre = (p + z * z / (2 * studies)) / scale;
      double half =
          z / scale * Math.sqrt(p * (1 - p) / studies + z * z / (4.0 * studies * studies));
      return new Finding(name, p, Math.max(0, centre - half), Math.min(1, centre + half));
    }
  }

  /** Keeps copies, so that it stays as it is. */
  public Power {
    findings = List.copyOf(findings);
  }

  /**
   * How often it is found.
   *
   * @param name of what is tested
   */
  public Finding finding(String name) {
    return findings.stream()
        .filter(finding -> finding.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " is not tested"));
  }

  /** The share of studies that find it. */
  public double share(String name) {
    return finding(name).share();
  }
}
