package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.Main;

/** A new study, from wherever the user is. */
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class ExperimentNewTest {
  @TempDir private Path folder;

  /** Runs a command in another working directory; returns its status and messages. */
  private String run(String... arguments) throws IOException, InterruptedException {
    String classes =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(entry -> Path.of(entry).toAbsolutePath().toString())
            .collect(Collectors.joining(File.pathSeparator));
    List<String> command =
        new ArrayList<>(
            List.of(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                classes,
                Main.class.getName(),
                "experiment"));
    command.addAll(List.of(arguments));
    Process process =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return process.waitFor() + ": " + said;
  }

  @Test
  void aNewStudyFindsTheProgramsScenesFromAnyFolder() throws IOException, InterruptedException {
    assertThat(run("new", "lab/mine")).isEqualTo("0: study: lab/mine/study.json\n");
    Path study = folder.resolve("lab/mine/study.json");
    assertThat(study).content().contains("\"scene\": \"../").doesNotContain("@scene@");
    assertThat(run("status", "lab/mine")).startsWith("0: ").contains("0 of 54 planned");
  }

  @Test
  void aSceneThatIsNotThereIsNamed() throws IOException, InterruptedException {
    assertThat(run("new", "mine", "--scene", "rooms.x3d"))
        .startsWith("2: ")
        .contains("--scene: there is no scene rooms.x3d");
    assertThat(Files.exists(folder.resolve("mine"))).isFalse();
  }
}
