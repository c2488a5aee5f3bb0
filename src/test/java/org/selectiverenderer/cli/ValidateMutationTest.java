package org.selectiverenderer.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.cli.author.ValidateCommand;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.validation.SceneMutator;
import org.selectiverenderer.validation.report.ReportFormat;

/** Corrupted scenes as the command meets them: an answer in time, a status, no stack trace. */
class ValidateMutationTest {
  private static final int CASES = 100;

  @TempDir Path folder;

  @ParameterizedTest
  @EnumSource
  void endsWithAStatusAndNoStackTraceInEveryFormat(ReportFormat format) throws IOException {
    SceneMutator mutants = new SceneMutator(format.ordinal());
    // Some scenes refer to ../inlineNodes, which lies within the folder of the test then.
    Path scenes = Files.createDirectory(folder.resolve("scenes"));
    for (int i = 0; i < CASES; i++) {
      Path scene = Files.write(scenes.resolve("scene.x3d"), mutants.next());
      assertTimeoutPreemptively(Duration.ofSeconds(30), () -> check(format, scene));
    }
  }

  private static void check(ReportFormat format, Path scene) throws IOException {
    byte[] content = Files.readAllBytes(scene);
    String file = run(InputStream.nullInputStream(), format, scene.toString(), content);
    String input = run(new ByteArrayInputStream(content), format, "-", content);
    assertThat(input.substring(0, 1)).isEqualTo(file.substring(0, 1));
  }

  /** The status, and what was printed. */
  private static String run(InputStream in, ReportFormat format, String path, byte[] content) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    Console console =
        new Console(new PrintStream(out, true, UTF_8), new PrintStream(err, true, UTF_8), false);
    String[] args = {"validate", path, "--format", format.name()};
    int status =
        new CommandRunner(console).run(args, List.of(new ValidateCommand(console, in))).code();
    String printed = out.toString(UTF_8);
    String scene = new String(content, UTF_8);
    assertThat(status).as(scene).isIn(0, 1);
    assertThat(err.toString(UTF_8)).as(scene).isEmpty();
    assertThat(printed).as(scene).doesNotContain("\tat ").doesNotContain("Exception");
    return status + printed;
  }
}
