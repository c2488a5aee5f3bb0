package org.selectiverenderer.base.markup;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MarkupTest {
  @Test
  void whatMarkupGivesAMeaningIsEscaped() {
    assertThat(Markup.text("a<b>&\"c'")).isEqualTo("a&lt;b&gt;&amp;\"c'");
    assertThat(Markup.attribute("a<b>&\"c'")).isEqualTo("a&lt;b&gt;&amp;&quot;c'");
  }

  @Test
  void whatXmlCannotHoldBecomesAQuestionMark() {
    assertThat(Markup.text("a\u0001\ud83d\uffffb\t\n\u00e9\ud83d\ude00"))
        .isEqualTo("a???b\t\n\u00e9\ud83d\ude00");
  }
}
