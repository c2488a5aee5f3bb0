package org.selectiverenderer.enricher.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.source.TextEdit;

class NormalizedTextTest {
  @Test
  void typingInAFileOfWindowsLineEndsKeepsThem() {
    NormalizedText text = NormalizedText.of("<a>\r\n<b/>\r\n</a>");
    assertThat(text.shown()).isEqualTo("<a>\n<b/>\n</a>");
    assertThat(text.change("<a>\n<b/>\n<c/>\n</a>")).isEqualTo(new TextEdit(12, 12, "c/>\r\n<"));
  }

  @Test
  void offsetsGoThereAndBackAcrossMixedLineEnds() {
    NormalizedText text = NormalizedText.of("a\r\nb\nc\rd");
    for (int shown = 0; shown <= text.shown().length(); shown++) {
      assertThat(text.inShown(text.inFile(shown))).isEqualTo(shown);
    }
    assertThat(text.inFile(2)).isEqualTo(3);
  }

  @Test
  void aSmallTextIsOnePageAndABigOneIsAPageAroundThePlace() {
    assertThat(VisibleSourceRange.around("<a/>\n", 3))
        .isEqualTo(new VisibleSourceRange(0, 5, false));
    String big = ("x".repeat(99) + "\n").repeat(40_000);
    VisibleSourceRange page = VisibleSourceRange.around(big, 2_000_000);
    assertThat(page.holds(2_000_000)).isTrue();
    assertThat(page.length()).isEqualTo(VisibleSourceRange.PAGE);
    assertThat(page.from() % 100).isZero();
    assertThat(page.withinLine()).isFalse();
  }

  @Test
  void aPageOfALineOfMillionsOfNumbersBeginsWithinIt() {
    VisibleSourceRange page =
        VisibleSourceRange.around("<a b='" + "1 ".repeat(2_000_000) + "'/>", 1_000_000);
    assertThat(page.withinLine()).isTrue();
    assertThat(page.holds(1_000_000)).isTrue();
  }
}
