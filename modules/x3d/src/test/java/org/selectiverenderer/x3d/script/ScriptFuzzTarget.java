package org.selectiverenderer.x3d.script;

import java.nio.charset.StandardCharsets;
import org.selectiverenderer.base.problem.SourceLocation;

/** Programs of Scripts, as the validator and the loader parse them. */
public final class ScriptFuzzTarget {
  private ScriptFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    String text = new String(input, StandardCharsets.UTF_8);
    ScriptProgram program = new ScriptProgram(text, SourceLocation.of("fuzz.js"));
    ScriptSyntax.of(program);
  }
}
