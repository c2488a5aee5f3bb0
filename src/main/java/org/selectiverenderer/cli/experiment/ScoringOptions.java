package org.selectiverenderer.cli.experiment;

import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import picocli.CommandLine.Option;

/** The options for the computation of d' and log beta from answers. */
final class ScoringOptions {
  private enum Rates {
    loglinear(ExtremeRateCorrection.LOG_LINEAR),
    half(ExtremeRateCorrection.HALF_TRIAL),
    none(ExtremeRateCorrection.NONE);

    private final ExtremeRateCorrection correction;

    Rates(ExtremeRateCorrection correction) {
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

  DetectionScorer scoring() {
    return new DetectionScorer(
        rates.correction,
        guesses == Guesses.discard ? LowConfidencePolicy.DISCARD : LowConfidencePolicy.AS_NO);
  }
}
