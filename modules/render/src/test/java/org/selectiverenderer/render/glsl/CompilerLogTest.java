package org.selectiverenderer.render.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The messages of drivers tell their place. */
class CompilerLogTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "0:12(5): error: `x' undeclared|12|6|`x' undeclared",
        "1(7) : error C1008: undefined variable x|7|0|undefined variable x",
        "ERROR: 1:3: 'x' : undeclared identifier|3|0|'x' : undeclared identifier",
        "1:2(3): preprocessor error: syntax error|2|4|syntax error",
        "error: no function with name 'main'|0|0|no function with name 'main'",
        "1:4(1): error: `sr_Vertices' undeclared|4|2|`gl_Vertices' undeclared"
      })
  void everyDriversWay(String log, int line, int column, String message) {
    assertThat(CompilerLog.of(log)).isEqualTo(new CompilerLog(line, column, message));
  }

  @ParameterizedTest
  @CsvSource("0:1(1): warning: unused|0:2(3): error: wrong")
  void warningsAreNoReason(String lines) {
    CompilerLog log = CompilerLog.of(lines.replace('|', '\n'));
    assertThat(log).isEqualTo(new CompilerLog(2, 4, "wrong"));
  }
}
