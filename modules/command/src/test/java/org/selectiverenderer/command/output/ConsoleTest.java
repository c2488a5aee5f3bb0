package org.selectiverenderer.command.output;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;

class ConsoleTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private final Console console =
      new Console(new PrintStream(out, true, UTF_8), new PrintStream(err, true, UTF_8), true);

  @Test
  void dataCommandsNoTerminal() {
    console.out().print("desk\u001b]0;title\u0007 \u009b2J\u202e\r\nTür \ud83d\ude00\t\u20ac\r.");
    console.out().flush();

    assertThat(out.toString(UTF_8))
        .isEqualTo("desk\\u001b]0;title\\u0007 \\u009b2J\\u202e\nTür \ud83d\ude00\t\u20ac\\u000d.");
  }

  @Test
  void charactersWrittenInPiecesAreSeenAsOne() {
    for (byte piece : "\u202eA\u009b\u20ac\r\n\u061c".getBytes(UTF_8)) {
      console.out().write(piece);
    }
    console.out().write('\r');
    console.out().flush();

    assertThat(out.toString(UTF_8)).isEqualTo("\\u202eA\\u009b\u20ac\n\\u061c\\u000d");
  }

  @Test
  void aMessageIsOneLine() {
    console.message("no such file: a\n::warning::b.x3d");
    console.problem(
        new Problem(Problem.Severity.ERROR, new SourceLocation("c\r\nd", 1, 2), "bad\u202e"));
    console.line("viewpoint\nforged");

    assertThat(err.toString(UTF_8).lines())
        .containsExactly("no such file: a\\u000a::warning::b.x3d", "c\\u000d\\u000ad:1:2: bad?");
    assertThat(out.toString(UTF_8).lines()).containsExactly("viewpoint\\u000aforged");
  }

  @Test
  void onlyTheProgramsOwnColoursReachTheTerminal() {
    console.out().print("first ");
    console.coloured("\u001b[1mbold\u001b[0m\n");
    console.overwrite("50 %\u001b[2J");

    assertThat(out.toString(UTF_8)).isEqualTo("first \u001b[1mbold\u001b[0m\n");
    assertThat(err.toString(UTF_8)).isEqualTo("\r50 %\\u001b[2J");
  }

  /** On Windows {@code println} and {@code %n} write CR and LF; what programs read is the same. */
  @Test
  void linesEndAlikeOnEverySystem() {
    console.out().print("one\r\ntwo\r\n");
    console.out().print("three\r");
    console.out().print("\n");
    console.err().print("told\r\n");
    console.out().flush();

    assertThat(out.toString(UTF_8)).isEqualTo("one\ntwo\nthree\n");
    assertThat(err.toString(UTF_8)).isEqualTo("told\n");
  }
}
