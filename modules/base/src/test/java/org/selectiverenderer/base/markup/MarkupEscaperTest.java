package org.selectiverenderer.base.markup;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MarkupEscaperTest {
  @Test
  void whatMarkupGivesAMeaningIsEscaped() {
    assertThat(MarkupEscaper.text("a<b>&\"c'")).isEqualTo("a&lt;b&gt;&amp;\"c'");
    assertThat(MarkupEscaper.attribute("a<b>&\"c'")).isEqualTo("a&lt;b&gt;&amp;&quot;c'");
  }

  @Test
  void whatXmlCannotHoldBecomesAQuestionMark() {
    assertThat(MarkupEscaper.text("a\u0001\ud83d\uffffb\t\n\u00e9\ud83d\ude00"))
        .isEqualTo("a???b\t\n\u00e9\ud83d\ude00");
  }
}
