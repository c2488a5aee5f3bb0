package org.selectiverenderer.base.markup;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;

class ControlCharacterEscaperTest {
  @Test
  void whatCommandsATerminalBecomesLetters() {
    assertThat(ControlCharacterEscaper.line("a\u001b[2J\u009b\u007f\r\n\u202e\u2066\u200f\u2028z"))
        .isEqualTo("a\\u001b[2J\\u009b\\u007f\\u000d\\u000a\\u202e\\u2066\\u200f\\u2028z");
  }

  @Test
  void otherTextStays() {
    String text = "Tür\t\u05d0\u200d \ud83d\ude00 \\u001b";
    assertThat(ControlCharacterEscaper.line(text)).isSameAs(text);
  }

  @Test
  void aNameOfAFileForgesNoLine() {
    assertThat(new SourceLocation("a\n::warning::.x3d", 3, 1))
        .hasToString("a\\u000a::warning::.x3d:3:1");
  }

  @Test
  void markupHasReferences() {
    assertThat(MarkupEscaper.text("\u009b\u202e\u001b<\n")).isEqualTo("&#x9b;&#x202e;?&lt;\n");
  }
}
