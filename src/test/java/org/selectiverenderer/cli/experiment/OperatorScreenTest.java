package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.testing.RequiresDisplay;

/** An X server with three screens: the first two are the participant's eyes. */
@RequiresDisplay
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class OperatorScreenTest {
  private static final int CORNER = 60;

  /** Bytes of an entry of XWD's list of colours. */
  private static final int COLOUR = 12;

  @TempDir private Path folder;
  private final List<Process> processes = new ArrayList<>();
  private String display = "";
  private Path study = Path.of("");

  @BeforeEach
  void server() throws IOException {
    boolean installed =
        Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
            .anyMatch(place -> Files.isExecutable(Path.of(place, "Xvfb")));
    assumeTrue(installed, "no Xvfb");
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
                "-screen",
                "2",
                "1280x1024x24",
                "-fbdir",
                folder.toString(),
                "-noreset")
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    processes.add(server);
    BufferedReader told = server.inputReader(StandardCharsets.UTF_8);
    display = ":" + told.readLine();
    Files.writeString(
        folder.resolve("hall.x3d"),
        "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint DEF='Here'/></Scene></X3D>");
    study =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Hall", "conditions": ["high"], "participants": 1, "scene": "hall.x3d",
             "display": {"mode": "dual", "hmd": "proview50"},
             "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}]}
            """);
  }

  @AfterEach
  void end() throws InterruptedException {
    for (int i = processes.size() - 1; i >= 0; i--) {
      processes.get(i).destroyForcibly().waitFor();
    }
  }

  private Process run(Path said, String... more) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "experiment",
                "run",
                study.toString(),
                "--participant",
                "001"));
    command.addAll(List.of(more));
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(said.toFile());
    builder.environment().put("DISPLAY", display);
    Process process = builder.start();
    processes.add(process);
    return process;
  }

  /** Whether there is something in the lower right corner of a screen, which Xvfb keeps as XWD. */
  private boolean lit(int screen) throws IOException {
    ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(folder.resolve("Xvfb_screen" + screen)));
    int width = file.getInt(4 * 4);
    int height = file.getInt(5 * 4);
    int line = file.getInt(12 * 4);
    int begin = file.getInt(0) + file.getInt(19 * 4) * COLOUR;
    for (int y = height - CORNER; y < height; y++) {
      for (int x = width - CORNER; x < width; x++) {
        if ((file.getInt(begin + y * line + 4 * x) & 0xffffff00) != 0) {
          return true;
        }
      }
    }
    return false;
  }

  @Test
  void theControlsOpenOnTheScreenThatNoEyeUses() throws IOException, InterruptedException {
    Path said = folder.resolve("messages.txt");
    Process session = run(said);
    while (!lit(0) && !lit(1) && !lit(2)) {
      assertThat(session.waitFor(100, TimeUnit.MILLISECONDS)).as(Files.readString(said)).isFalse();
    }
    assertThat(List.of(lit(0), lit(1), lit(2))).containsExactly(false, false, true);
  }

  @Test
  void anEyesMonitorIsRefusedForTheOperatorBeforeAnythingIsWritten()
      throws IOException, InterruptedException {
    Path said = folder.resolve("messages.txt");
    assertThat(run(said, "--operator-monitor", "1").waitFor()).isEqualTo(2);
    assertThat(said)
        .content()
        .contains("monitor '1' shows the participant's right eye; name another", "2: 1280x1024");
    assertThat(folder.resolve("sub-001")).doesNotExist();
  }
}
