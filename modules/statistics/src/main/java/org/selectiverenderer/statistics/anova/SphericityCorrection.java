package org.selectiverenderer.statistics.anova;

import java.util.Optional;

/**
 * How the degrees of freedom of effects on three or more within levels are corrected for violated
 * sphericity.
 */
public enum SphericityCorrection {
  /**
   * Corrected where Mauchly's test or epsilon indicates a violation, see {@link #corrected}: by
   * Huynh and Feldt where Greenhouse and Geisser's epsilon is above 0.75, else by the latter
   * (Girden 1992, ANOVA: Repeated Measures).
   */
  AUTO("auto"),
  /** Always Greenhouse and Geisser's epsilon. */
  GREENHOUSE_GEISSER("gg"),
  /** Always Huynh and Feldt's. */
  HUYNH_FELDT("hf"),
  /** Never corrected. */
  NONE("none");

  private static final double CONSERVATIVE = 0.75;

  private final String word;

  SphericityCorrection(String word) {
    this.word = word;
  }

  /** Returns the name on the command line and in JSON. */
  public String word() {
    return word;
  }

  /** Returns the correction to apply to an effect; never {@link #AUTO}. */
  SphericityCorrection of(Sphericity found, double alpha) {
    if (this != AUTO) {
      return this;
    }
    // With too few subjects for Mauchly's test, sphericity is not assumed.
    boolean violated = !(found.mauchlyP() >= alpha);
    boolean small = found.greenhouseGeisser() <= CONSERVATIVE;
    return small ? GREENHOUSE_GEISSER : violated ? HUYNH_FELDT : NONE;
  }

  /** Returns the corrected degrees of freedom of an effect; empty if they are not corrected. */
  Optional<CorrectedDegreesOfFreedom> corrected(
      Sphericity found, double df1, double df2, double alpha) {
    return switch (of(found, alpha)) {
      case GREENHOUSE_GEISSER ->
          Optional.of(
              CorrectedDegreesOfFreedom.of(
                  GREENHOUSE_GEISSER, found.greenhouseGeisser(), df1, df2));
      case HUYNH_FELDT ->
          Optional.of(CorrectedDegreesOfFreedom.of(HUYNH_FELDT, found.huynhFeldt(), df1, df2));
      case AUTO, NONE -> Optional.empty();
    };
  }
}
