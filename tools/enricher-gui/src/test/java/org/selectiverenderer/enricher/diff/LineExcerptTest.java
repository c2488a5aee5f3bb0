package org.selectiverenderer.enricher.diff;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LineExcerptTest {
  private static final String NUMBERS = "1 2.5 -3 ".repeat(1000);

  private static String marked(LineExcerpt excerpt) {
    return excerpt.text().substring(excerpt.from(), excerpt.to());
  }

  @Test
  void aLineWithRoomIsWholeAndItsDifferenceMarked() {
    LineExcerpt mine = LineExcerpt.of("<Shape DEF='Mug'/>", "<Shape DEF='Glass'/>", 40);
    assertThat(mine.text()).isEqualTo("<Shape DEF='Mug'/>");
    assertThat(marked(mine)).isEqualTo("Mug");
    assertThat(mine.cut()).isFalse();
  }

  @Test
  void aLongLineIsCutAroundItsDifference() {
    String mine = "<Coordinate point='" + NUMBERS + "7 " + NUMBERS + "'/>";
    String theirs = "<Coordinate point='" + NUMBERS + "8.25 " + NUMBERS + "'/>";
    LineExcerpt shown = LineExcerpt.of(mine, theirs, 60);
    assertThat(shown.text()).hasSize(60).startsWith("\u2026").endsWith("\u2026");
    assertThat(marked(shown)).isEqualTo("7");
    assertThat(shown.from()).isEqualTo(21);
    assertThat(shown.cut()).isTrue();
  }

  @Test
  void aDifferenceAtTheEndIsShownToTheEnd() {
    LineExcerpt shown = LineExcerpt.of(NUMBERS + "a", NUMBERS + "b", 30);
    assertThat(shown.text()).hasSize(30).startsWith("\u2026").endsWith(" a");
    assertThat(marked(shown)).isEqualTo("a");
  }

  @Test
  void aDifferenceAtTheBeginningIsShownFromTheBeginning() {
    LineExcerpt shown = LineExcerpt.of("a" + NUMBERS, "b" + NUMBERS, 30);
    assertThat(shown.text()).hasSize(30).startsWith("a1 2.5").endsWith("\u2026");
    assertThat(marked(shown)).isEqualTo("a");
  }

  @Test
  void aLineThatTheOtherGoesOnFromMarksNothing() {
    assertThat(marked(LineExcerpt.of(NUMBERS, NUMBERS + "9", 30))).isEmpty();
    assertThat(marked(LineExcerpt.of("", "9", 30))).isEmpty();
  }

  @Test
  void noPairOfSurrogatesIsCut() {
    String cups = "\uD83C\uDF75".repeat(100);
    for (int room = 12; room < 60; room++) {
      LineExcerpt shown = LineExcerpt.of(cups + "a" + cups, cups + "b" + cups, room);
      assertThat(shown.text().codePoints()).allMatch(c -> c > 0xFFFF || c < 0xD800);
      assertThat(marked(shown)).isEqualTo("a");
    }
    LineExcerpt pair = LineExcerpt.of("x\uD83C\uDF75", "x\uD83C\uDF76", 10);
    assertThat(marked(pair)).isEqualTo("\uD83C\uDF75");
  }
}
