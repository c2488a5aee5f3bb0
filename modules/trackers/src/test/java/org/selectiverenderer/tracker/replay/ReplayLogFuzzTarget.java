package org.selectiverenderer.tracker.replay;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.testing.FuzzFile;

/** Recorded poses, replayed as a tracker. */
public final class ReplayLogFuzzTarget {
  private ReplayLogFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with("log.csv", input, file -> ReplayLog.read(file, new ProblemCollector()));
  }
}
