package org.selectiverenderer.apparatus;

import java.nio.charset.StandardCharsets;
import org.selectiverenderer.base.problem.ProblemCollector;

/** Display profiles. */
public final class DisplayProfileFuzzTarget {
  private DisplayProfileFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    DisplayProfileLoader.parse(
        "fuzz.json", new String(input, StandardCharsets.UTF_8), new ProblemCollector());
  }
}
