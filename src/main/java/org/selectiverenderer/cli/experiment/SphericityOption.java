package org.selectiverenderer.cli.experiment;

import java.util.Arrays;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.SphericityCorrection;
import picocli.CommandLine.Option;

/** The option for the correction of degrees of freedom where sphericity is violated. */
final class SphericityOption {
  /** The values as users write them. */
  enum Words {
    auto,
    gg,
    hf,
    none
  }

  @Option(
      names = "--sphericity",
      paramLabel = "C",
      defaultValue = "auto",
      description =
          "correction of degrees of freedom for effects on three or more within levels: "
              + "${COMPLETION-CANDIDATES}; gg is Greenhouse-Geisser, hf Huynh-Feldt, auto one of "
              + "them where epsilon or Mauchly's test asks for it (default: ${DEFAULT-VALUE})")
  private Words choice = Words.auto;

  AnovaOptions in(AnovaOptions options) {
    return in(options, Optional.empty());
  }

  /**
   * Returns ANOVA options with the chosen correction.
   *
   * @param other the value of the option's other spelling, which takes precedence
   */
  AnovaOptions in(AnovaOptions options, Optional<Words> other) {
    String word = other.orElse(choice).name();
    return options.withSphericity(
        Arrays.stream(SphericityCorrection.values())
            .filter(known -> known.word().equals(word))
            .findFirst()
            .orElseThrow());
  }
}
