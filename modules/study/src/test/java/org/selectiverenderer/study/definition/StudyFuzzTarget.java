package org.selectiverenderer.study.definition;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.testing.FuzzFile;

/** Studies: study.json. */
public final class StudyFuzzTarget {
  private StudyFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with("study.json", input, file -> StudyReader.read(file, new ProblemCollector()));
  }
}
