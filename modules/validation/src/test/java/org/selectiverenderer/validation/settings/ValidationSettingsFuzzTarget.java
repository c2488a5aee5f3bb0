package org.selectiverenderer.validation.settings;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.testing.FuzzFile;
import org.selectiverenderer.validation.run.RuleCatalogue;

/** The validator's settings and baselines. */
public final class ValidationSettingsFuzzTarget {
  private static final RuleCatalogue RULES = RuleCatalogue.standard();

  private ValidationSettingsFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with(
        "validate.json",
        input,
        file -> {
          new ValidationSettingsReader(file, RULES).read(new ProblemCollector());
          Baseline.read(file);
        });
  }
}
