package org.selectiverenderer.study.headlog;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.testing.FuzzFile;

/** Head logs, beside the description of a good one. */
public final class HeadLogFuzzTarget {
  private HeadLogFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with("log.csv", input, file -> HeadLogReader.read(file, new ProblemCollector()));
  }
}
