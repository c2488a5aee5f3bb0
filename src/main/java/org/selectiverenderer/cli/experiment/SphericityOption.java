package org.selectiverenderer.cli.experiment;

import java.util.Arrays;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.SphericityChoice;
import picocli.CommandLine.Option;

/** What is done where sphericity is lacking. */
final class SphericityOption {
  /** As users write them. */
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
   * The options with the choice.
   *
   * @param other what another spelling of the option says, which then counts
   */
  AnovaOptions in(AnovaOptions options, Optional<Words> other) {
    String word = other.orElse(choice).name();
    return options.withSphericity(
        Arrays.stream(SphericityChoice.values())
            .filter(known -> known.word().equals(word))
            .findFirst()
            .orElseThrow());
  }
}
