package org.selectiverenderer.study.threshold;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.testing.FuzzFile;

/** Pilot studies. */
public final class ThresholdStudyFuzzTarget {
  private ThresholdStudyFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with(
        "pilot.json", input, file -> ThresholdStudyReader.read(file, new ProblemCollector()));
  }
}
