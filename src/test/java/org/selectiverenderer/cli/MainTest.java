package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import picocli.CommandLine.Command;

class MainTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @Test
  void versionIsTheBuildsOwn() {
    assertThat(execute("--version")).isZero();
    assertThat(text(out)).matches("selective-renderer \\d+\\.\\d+\\.\\d+\\S*\\R");
    assertThat(text(err)).isEmpty();
  }

  @Test
  void helpShowsAnExample() {
    assertThat(execute("--help")).isZero();
    assertThat(text(out)).contains("Example:", "./selective-renderer run scenes/trashcan.x3d");
  }

  @Test
  void withoutACommandItSaysHowToGetHelp() {
    assertThat(execute()).isEqualTo(2);
    assertThat(text(out)).isEmpty();
    assertThat(text(err)).contains("no command given", "--help").hasLineCount(2);
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
    out.reset();
    assertThat(execute(name, "--help")).isZero();
    assertThat(text(out)).containsSubsequence("Example:", "selective-renderer " + name);
  }

  private int execute(String... args) {
    return Main.execute(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private static String text(ByteArrayOutputStream stream) {
    return stream.toString(StandardCharsets.UTF_8);
  }
}
