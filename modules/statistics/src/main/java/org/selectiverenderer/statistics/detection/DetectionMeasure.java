package org.selectiverenderer.statistics.detection;

/** The dependent variables of the study. */
public enum DetectionMeasure {
  /** Sensitivity: how well present and absent objects are told apart. */
  D_PRIME("d_prime", "d′", "sensitivity"),
  /** Bias as the logarithm of the likelihood ratio at the criterion. */
  LOG_BETA("log_beta", "log β", "bias; above 0: towards “no”"),
  /** Bias as the location of the criterion. */
  CRITERION("c", "c", "criterion; above 0: towards “no”");

  private final String key;
  private final String symbol;
  private final String meaning;

  DetectionMeasure(String key, String symbol, String meaning) {
    this.key = key;
    this.symbol = symbol;
    this.meaning = meaning;
  }

  /** Returns the name in files. */
  public String key() {
    return key;
  }

  /** Returns the symbol in tables. */
  public String symbol() {
    return symbol;
  }

  /** Returns a description in words. */
  public String meaning() {
    return meaning;
  }

  /** Returns the value of this measure; NaN when it is not defined. */
  public double of(DetectionIndices detection) {
    return switch (this) {
      case D_PRIME -> detection.dPrime();
      case LOG_BETA -> detection.logBeta();
      case CRITERION -> detection.criterion();
    };
  }
}
