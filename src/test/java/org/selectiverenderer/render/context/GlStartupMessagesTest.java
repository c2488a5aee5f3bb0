package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.RequiresDisplay;

/** Programs that draw say what the display lacks. JOGL begins once, so each is a process. */
@EnabledOnOs(OS.LINUX)
class GlStartupMessagesTest {
  private static String draws(Map<String, String> environment) throws Exception {
    ProcessBuilder builder = process();
    builder.environment().putAll(environment);
    Process process = builder.start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).as(text).isEqualTo(2);
    return text;
  }

  private static ProcessBuilder process() throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp",
            System.getProperty("java.class.path"),
            Main.class.getName(),
            "run",
            "scenes/hello.x3d",
            "--offscreen",
            "--size",
            "64x64",
            "--duration",
            "0.1")
        .redirectErrorStream(true);
  }

  @Test
  @RequiresDisplay
  void aDriverWithoutOpenGl3IsTold() throws Exception {
    assertThat(draws(Map.of("MESA_GL_VERSION_OVERRIDE", "2.1")))
        .contains("the display's driver has no OpenGL 3.3", "LIBGL_ALWAYS_SOFTWARE")
        .doesNotContain("not available on");
  }

  @Test
  void aDisplayThatNobodyServesIsTold() throws Exception {
    assertThat(draws(Map.of("DISPLAY", ":7654"))).contains("no X server answers at DISPLAY=:7654");
  }
}
