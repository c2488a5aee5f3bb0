package org.selectiverenderer.statistics.detection;

/** Corrections of extreme rates (0 and 1), whose z is infinite. */
public enum ExtremeRateCorrection {
  /**
   * Adds 0.5 to the count and 1 to the number of answers, for all rates alike (Hautus 1995,
   * Behavior Research Methods, Instruments and Computers 27).
   */
  LOG_LINEAR("log-linear (0.5 added to counts, 1 to totals; Hautus 1995)") {
    @Override
    double rate(int count, int total) {
      return (count + 0.5) / (total + 1.0);
    }
  },
  /**
   * Replaces 0 by 1/(2N) and 1 by 1 - 1/(2N) (Macmillan and Kaplan 1985, Psychological Bulletin
   * 98).
   */
  HALF_TRIAL("1/(2N) for 0, 1 - 1/(2N) for 1 (Macmillan and Kaplan 1985)") {
    @Override
    double rate(int count, int total) {
      double half = 0.5 / total;
      return Math.min(1 - half, Math.max(half, count / (double) total));
    }
  },
  /** No correction: participants with such rates have no d'. */
  NONE("none; rates of 0 and 1 have no z") {
    @Override
    double rate(int count, int total) {
      return count / (double) total;
    }
  };

  private final String description;

  ExtremeRateCorrection(String description) {
    this.description = description;
  }

  /** Returns the description used in reports. */
  public String description() {
    return description;
  }

  /**
   * Returns the corrected rate.
   *
   * @param total at least 1
   */
  abstract double rate(int count, int total);
}
