package org.selectiverenderer.cli.experiment;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import picocli.CommandLine.Option;

/**
 * The options for the bounds of equivalence tests, shared by the commands that compute an ANOVA.
 */
final class EquivalenceBoundOptions {
  @Option(
      names = "--bounds",
      paramLabel = "B|Bsd",
      defaultValue = "0.5sd",
      description =
          "bound of the equivalence test (TOST): differences from -B to B do not "
              + "matter; in units of the measure, or in standard deviations with sd "
              + "(default: ${DEFAULT-VALUE})")
  private String bounds = "";

  @Option(
      names = "--eta-bound",
      paramLabel = "E",
      description =
          "bound of the equivalence test of effects: a partial eta squared below E does "
              + "not matter (default: 0.06)")
  private @Nullable Double etaBound;

  AnovaOptions options() {
    boolean standard = bounds.endsWith("sd");
    String number = standard ? bounds.substring(0, bounds.length() - 2) : bounds;
    if (!number.matches("\\d*\\.?\\d+") || !(Double.parseDouble(number) > 0)) {
      throw CommandException.usage(
          "--bounds must be a number above 0, with or without sd, not " + bounds);
    }
    if (etaBound != null && !(etaBound > 0 && etaBound < 1)) {
      throw CommandException.usage("--eta-bound must be a number between 0 and 1, not " + etaBound);
    }
    AnovaOptions options =
        standard
            ? AnovaOptions.DEFAULT.withStandardBound(Double.parseDouble(number))
            : AnovaOptions.DEFAULT.withRawBound(Double.parseDouble(number));
    return etaBound == null ? options : options.withEtaBound(etaBound);
  }
}
