package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;

/** The program as an author starts it, in a process of its own. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class ProgramStartTest {
  @TempDir Path home;

  private ProcessBuilder enricher(String display) {
    ProcessBuilder builder =
        new ProcessBuilder(
                List.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-cp",
                    System.getProperty("java.class.path"),
                    "-Duser.home=" + home,
                    Main.class.getName(),
                    "enrich",
                    "scenes/apartment-plain.x3d"))
            .redirectErrorStream(true);
    builder.environment().put("DISPLAY", display);
    builder.environment().put("XDG_CONFIG_HOME", home.toString());
    return builder;
  }

  private static int[] screen(Robot robot) {
    Rectangle all = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
    BufferedImage image = robot.createScreenCapture(all);
    return image.getRGB(0, 0, all.width, all.height, null, 0, all.width);
  }

  @Test
  void theCommandOpensTheWindow() throws Exception {
    Robot robot = new Robot();
    int[] before = screen(robot);
    Process process = enricher(System.getenv("DISPLAY")).start();
    try {
      Eventually.await(
          "the window", () -> !process.isAlive() || !Arrays.equals(before, screen(robot)));
      assertThat(process.isAlive()).as("the window stays").isTrue();
    } finally {
      process.destroy();
      process.waitFor();
    }
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "there is no DISPLAY there")
  void aDisplayThatCannotBeReachedIsToldInOneLine() throws IOException, InterruptedException {
    Process process = enricher(":4711").start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).isNotZero();
    assertThat(said.lines())
        .containsExactly(
            "selective-renderer enrich: the enricher's window needs a display; "
                + "without a display use enrich with --apply or --ratings");
  }
}
