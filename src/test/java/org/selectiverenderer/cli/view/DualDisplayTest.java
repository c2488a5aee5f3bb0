package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.RequiresDisplay;

/** Both eyes on the two screens of an X server, as the ProView is wired. */
@RequiresDisplay
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class DualDisplayTest {
  @TempDir private Path folder;

  private static boolean installed(String program) {
    return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
        .anyMatch(place -> Files.isExecutable(Path.of(place, program)));
  }

  @Test
  void eachEyeFillsAScreenOfItsOwn() throws IOException, InterruptedException {
    assumeTrue(installed("Xvfb"), "no Xvfb");
    Process server =
        new ProcessBuilder(
                "Xvfb",
                "-displayfd",
                "1",
                "-screen",
                "0",
                "640x480x24",
                "-screen",
                "1",
                "640x480x24",
                "-fbdir",
                folder.toString(),
                "-noreset")
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try (BufferedReader told = server.inputReader(StandardCharsets.UTF_8)) {
      String display = ":" + told.readLine();
      Path screenshot = folder.resolve("dual.png");
      Path log = folder.resolve("messages.txt");
      ProcessBuilder run =
          new ProcessBuilder(
                  ProcessHandle.current().info().command().orElse("java"),
                  "-cp",
                  System.getProperty("java.class.path"),
                  Main.class.getName(),
                  "run",
                  "scenes/trashcan.x3d",
                  "--display",
                  "dual",
                  "--duration",
                  "2",
                  "--samples",
                  "0",
                  "--screenshot",
                  screenshot.toString())
              .redirectErrorStream(true)
              .redirectOutput(log.toFile());
      run.environment().put("DISPLAY", display);
      assertThat(run.start().waitFor()).as(Files.readString(log)).isZero();
      assertThat(Files.readString(log))
          .contains("left eye: monitor 640x480", "right eye: monitor 640x480", "of X screen 1");
      BufferedImage both = ImageIO.read(screenshot.toFile());
      assertThat(both.getWidth()).isEqualTo(1280);
      // The two halves differ, as two eyes' pictures do.
      assertThat(both.getRGB(0, 0, 640, 480, null, 0, 640))
          .isNotEqualTo(both.getRGB(640, 0, 640, 480, null, 0, 640));
    } finally {
      server.destroy();
      server.waitFor();
    }
  }
}
