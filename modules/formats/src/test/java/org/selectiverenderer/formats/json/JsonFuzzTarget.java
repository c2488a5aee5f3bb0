package org.selectiverenderer.formats.json;

import java.nio.charset.StandardCharsets;
import java.util.function.Function;
import org.selectiverenderer.base.problem.ProblemCollector;

/** JSON with comments, as settings files are written in. */
public final class JsonFuzzTarget {
  private JsonFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    new JsonSettingsReader("the settings", "they are not used")
        .parse(
            "fuzz.json",
            new String(input, StandardCharsets.UTF_8),
            new ProblemCollector(),
            Function.identity());
  }
}
