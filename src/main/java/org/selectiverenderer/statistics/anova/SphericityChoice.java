package org.selectiverenderer.statistics.anova;

import java.util.Optional;

/** What the degrees of freedom of an effect on three or more within levels are multiplied with. */
public enum SphericityChoice {
  /**
   * Corrected where Mauchly's test or epsilon says so, see {@link #corrected}: by Huynh and Feldt
   * where Greenhouse and Geisser's epsilon is above 0.75, else by the latter (Girden 1992, ANOVA:
   * Repeated Measures).
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

  SphericityChoice(String word) {
    this.word = word;
  }

  /** As the command line and JSON write it. */
  public String word() {
    return word;
  }

  /** What is done about an effect; {@link #AUTO} is never the answer. */
  SphericityChoice of(Sphericity found, double alpha) {
    if (this != AUTO) {
      return this;
    }
    // Too few subjects for Mauchly's test are too few to trust sphericity.
    boolean violated = !(found.mauchlyP() >= alpha);
    boolean small = found.greenhouseGeisser() <= CONSERVATIVE;
    return small ? GREENHOUSE_GEISSER : violated ? HUYNH_FELDT : NONE;
  }

  /** The correction of an effect, empty if there is none. */
  Optional<CorrectedDf> corrected(Sphericity found, double df1, double df2, double alpha) {
    return switch (of(found, alpha)) {
      case GREENHOUSE_GEISSER ->
          Optional.of(CorrectedDf.of(GREENHOUSE_GEISSER, found.greenhouseGeisser(), df1, df2));
      case HUYNH_FELDT -> Optional.of(CorrectedDf.of(HUYNH_FELDT, found.huynhFeldt(), df1, df2));
      case AUTO, NONE -> Optional.empty();
    };
  }
}
