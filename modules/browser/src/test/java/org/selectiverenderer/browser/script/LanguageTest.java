package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The constructs of ECMAScript that docs/scripts.md promises, and what is said of the others. */
class LanguageTest {
  private static final Pattern ROW =
      Pattern.compile("\\| 20\\d\\d \\| .* \\| `([^`]+)` \\| (?:`([^`]+)`|not supported) \\|");

  private static final ScriptLimits LIMITS = ScriptFixture.countedLimits(30, 30, 1 << 30);

  record Example(String program, String result) {}

  static Stream<Example> examples() throws IOException {
    return Files.readString(Path.of("docs/scripts.md"))
        .lines()
        .map(ROW::matcher)
        .filter(Matcher::matches)
        .map(row -> new Example(row.group(1), row.group(2)));
  }

  private static ScriptFixture run(String program) throws IOException {
    return new ScriptFixture(
        "<Script DEF='S'><field name='out' type='SFString' accessType='outputOnly'/>"
            + "<![CDATA[ecmascript:"
            + program
            + "]]></Script>",
        LIMITS);
  }

  @ParameterizedTest
  @MethodSource("examples")
  void theTableOfConstructsIsTrue(Example example) throws IOException {
    String program =
        example.result == null
            ? example.program
            : "out = '' + eval(\"%s\");".formatted(example.program.replace("\"", "\\\""));
    try (ScriptFixture scene = run(program)) {
      if (example.result == null) {
        assertThat(scene.told())
            .singleElement()
            .asString()
            .contains(", at column ")
            .contains(" is not supported; ");
      } else {
        assertThat(scene.told()).isEmpty();
        assertThat(scene.value("S", "out")).isEqualTo(example.result);
      }
    }
  }

  @Test
  void theTableIsThere() throws IOException {
    assertThat(examples()).hasSizeGreaterThan(20);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      textBlock =
          """
          var o = {n: 0, get g() { this.n++; return this; }, f() { return arguments.length + this.n; }}; o.g.f(...[1, 2]) | 3
          var o = {f(a, b) { return (this === o) + a + b; }}; o['f'](...'xy') | truexy
          var q = [1]; q.push(...q, ...q); q.join() | 1,1,1
          new Date(...[2020, 1, 1]).getFullYear() | 2020
          Math.max(...new Set([1, 9])) | 9
          (function () { return arguments.length; })(...[1, 2], ...[]) | 2
          const f = x => x + 1; const g = x => x * 2; g(f(1)) | 4
          function f(n) { if (n) { const x = 1; return x; } else { const x = 2; return x; } } f(0) | 2
          var c = 0; { const c = 1; } c | 0
          var s = ''; for (const [k, v] of [[1, 2]]) { const z = k + v; s += z; } s | 3
          try { ({}).x(...[1]); } catch (e) { e.name } | TypeError
          """)
  void spreadAndConstDoWhatTheyShould(String program, String result) throws IOException {
    theTableOfConstructsIsTrue(new Example(program, result));
  }

  @Test
  void spreadInAnOptionalCallIsAnError() throws IOException {
    try (ScriptFixture scene = run("var o;\no?.f(...[1]);")) {
      assertThat(scene.told()).singleElement().asString().contains("spread (...)");
    }
  }

  @Test
  void spreadReachesNoJava() throws IOException {
    try (ScriptFixture scene = run("out = '' + [...5][0];")) {
      assertThat(scene.value("S", "out")).asString().doesNotContain("getClass");
      assertThat(List.copyOf(scene.told()).toString()).doesNotContain("notifyAll");
    }
  }
}
