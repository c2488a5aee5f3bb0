package org.selectiverenderer.browser.viewer;

import java.nio.charset.StandardCharsets;
import org.selectiverenderer.base.problem.ProblemCollector;

/** Recorded paths of the camera. */
public final class CameraPathFuzzTarget {
  private CameraPathFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    CameraPathReader.parse(
        "fuzz.csv", new String(input, StandardCharsets.UTF_8), new ProblemCollector());
  }
}
