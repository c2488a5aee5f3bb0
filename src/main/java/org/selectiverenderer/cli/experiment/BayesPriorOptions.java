package org.selectiverenderer.cli.experiment;

import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.EffectPrior;
import picocli.CommandLine.Option;

/** The options for the prior of the effects' Bayes factors. */
final class BayesPriorOptions {
  private static final double LEAST = 0.01;
  private static final double MOST = 10;

  @Option(
      names = "--prior",
      paramLabel = "R",
      defaultValue = "0.5",
      description =
          "width of the prior of effects in their Bayes factors: 0.5 is medium, 0.707 wide, 1 "
              + "ultrawide (default: ${DEFAULT-VALUE})")
  private double fixed;

  @Option(
      names = "--prior-random",
      paramLabel = "R",
      defaultValue = "1",
      description =
          "width of the prior of participants in the Bayes factors of effects "
              + "(default: ${DEFAULT-VALUE})")
  private double random;

  @Option(
      names = "--bayes-seed",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "seed of the Monte Carlo integral, which only designs with two or more between factors "
              + "and unequal groups need (default: ${DEFAULT-VALUE})")
  private long seed;

  AnovaOptions in(AnovaOptions options) {
    check("--prior", fixed);
    check("--prior-random", random);
    return options.withPrior(new EffectPrior(fixed, random, seed));
  }

  private static void check(String name, double width) {
    if (!(width >= LEAST && width <= MOST)) {
      throw CommandException.usage(
          "%s must be a number from %s to %s, not %s"
              .formatted(name, LEAST, Math.round(MOST), width));
    }
  }
}
