package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.command.ProgramInvocation;
import org.selectiverenderer.command.output.Console;
import picocli.CommandLine.Command;

class MainTest extends CommandTestCase {
  @Test
  void versionIsTheBuildsOwn() {
    assertThat(execute("--version")).isZero();
    assertThat(text(out)).matches("selective-renderer \\d+\\.\\d+\\.\\d+\\S*\\R");
    assertThat(text(err)).isEmpty();
  }

  @Test
  void helpShowsAnExample() {
    assertThat(execute("--help")).isZero();
    assertThat(text(out))
        .contains("Example:", ProgramInvocation.in("./selective-renderer run scenes/trashcan.x3d"));
  }

  @Test
  void withoutACommandItSaysHowToGetHelp() {
    assertThat(execute()).isEqualTo(2);
    assertThat(text(out)).isEmpty();
    assertThat(text(err)).contains("no command given", "--help").hasLineCount(2);
  }

  @Test
  void reportsHaveTheSameDigitsWhereverTheyAreMade(@TempDir Path folder) throws Exception {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(scene, "<X3D profile='Immersive' version='4.0'><Scene/></X3D>");
    Process program =
        new ProcessBuilder(
                ProcessHandle.current().info().command().orElseThrow(),
                "-Duser.language=ar",
                "-Duser.country=EG",
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "validate",
                scene.toString(),
                "--format",
                "junit")
            .redirectErrorStream(true)
            .start();
    String report = new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(report).contains("tests=\"1\"");
  }

  @TestFactory
  Iterable<DynamicTest> everyCommandExplainsItself() {
    Console console = new Console(new PrintStream(out), new PrintStream(err), false);
    return CommandCatalogue.commands(console).stream()
        .map(command -> command.getClass().getAnnotation(Command.class).name())
        .map(name -> DynamicTest.dynamicTest(name, () -> assertExplained(name)))
        .toList();
  }

  private void assertExplained(String name) {
    assertThat(execute(name, "--help")).isZero();
    assertThat(text(out)).containsSubsequence("Example:", "selective-renderer " + name);
  }
}
