package org.selectiverenderer.cli.experiment;

import org.selectiverenderer.statistics.detection.Correction;
import org.selectiverenderer.statistics.detection.Guessing;
import org.selectiverenderer.statistics.detection.Scoring;
import picocli.CommandLine.Option;

/** The options for the computation of d' and log beta from answers. */
final class ScoringChoices {
  private enum Rates {
    loglinear(Correction.LOG_LINEAR),
    half(Correction.HALF_TRIAL),
    none(Correction.NONE);

    private final Correction correction;

    Rates(Correction correction) {
      this.correction = correction;
    }
  }

  private enum Guesses {
    discard,
    no
  }

  @Option(
      names = "--correction",
      paramLabel = "RULE",
      defaultValue = "loglinear",
      description =
          "correction of rates of 0 and 1: ${COMPLETION-CANDIDATES} (Hautus 1995; "
              + "1/(2N), Macmillan and Kaplan 1985; none) (default: ${DEFAULT-VALUE})")
  private Rates rates = Rates.loglinear;

  @Option(
      names = "--guesses",
      paramLabel = "KIND",
      defaultValue = "discard",
      description =
          "treatment of answers below a level of confidence: left out (discard) or "
              + "counted as no (no) (default: ${DEFAULT-VALUE})")
  private Guesses guesses = Guesses.discard;

  Scoring scoring() {
    return new Scoring(
        rates.correction, guesses == Guesses.discard ? Guessing.DISCARD : Guessing.AS_NO);
  }
}
