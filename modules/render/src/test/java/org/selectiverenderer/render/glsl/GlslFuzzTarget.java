package org.selectiverenderer.render.glsl;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.selectiverenderer.browser.instance.ShaderProgramSource;

/** Custom shaders, whose names are found and translated. */
public final class GlslFuzzTarget {
  private GlslFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    String text = new String(input, StandardCharsets.UTF_8);
    GlslTranslator translator = new GlslTranslator();
    for (ShaderProgramSource.Stage stage : ShaderProgramSource.Stage.values()) {
      translator.translate(List.of(new GlslTranslator.Given(stage, text)));
    }
  }
}
