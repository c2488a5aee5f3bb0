package org.selectiverenderer.enricher.diff;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.file.UnifiedDiff;
import org.selectiverenderer.enricher.diff.DiffLines.Kind;

class DiffLinesTest {
  private static DiffLines diff(String before, String after) {
    return DiffLines.of(UnifiedDiff.of("a.x3d", "b.x3d", before, after));
  }

  @Test
  void linesAreWhatTheirSignsSay() {
    DiffLines diff = diff("one\n--two\nthree\n", "one\n++two\nthree\n");
    assertThat(diff.lines())
        .extracting(DiffLines.Line::kind)
        .containsExactly(
            Kind.FILE, Kind.FILE, Kind.PLACE, Kind.SAME, Kind.REMOVED, Kind.ADDED, Kind.SAME);
    assertThat(diff.added()).isEqualTo(1);
    assertThat(diff.removed()).isEqualTo(1);
  }

  @Test
  void aRemovedLineThatLooksLikeAHeadIsARemovedLine() {
    assertThat(diff("-- a\nx\n", "x\n").lines().get(3))
        .isEqualTo(new DiffLines.Line(Kind.REMOVED, "--- a"));
  }

  @Test
  void oneGoesFromChangeToChangeAndRound() {
    String same = "s\n".repeat(10);
    DiffLines diff = diff("a\n" + same + "b\n", "A\n" + same + "B\n");
    assertThat(diff.changes()).hasSize(2);
    int first = diff.changes().get(0);
    int second = diff.changes().get(1);
    assertThat(diff.next(-1)).isEqualTo(first);
    assertThat(diff.next(first)).isEqualTo(second);
    assertThat(diff.next(second)).isEqualTo(first);
    assertThat(diff.previous(second)).isEqualTo(first);
    assertThat(diff.previous(first)).isEqualTo(second);
  }

  @Test
  void equalTextsHaveNoLines() {
    assertThat(diff("a\n", "a\n").lines()).isEmpty();
    assertThat(diff("a\n", "a\n").next(0)).isEqualTo(-1);
  }

  @Test
  void endsOfWindowsLinesAreNotShown() {
    assertThat(diff("a\r\n", "b\r\n").lines().get(3).text()).isEqualTo("-a");
  }

  @Test
  void aRemovedLineIsBesideTheAddedOneOfItsNumber() {
    DiffLines diff = DiffLines.of("--- a\n+++ b\n@@ -1 +1 @@\n same\n-a\n-b\n-c\n+A\n+B\n end\n");
    assertThat(diff.beside(3)).isEmpty();
    assertThat(diff.beside(4)).isEqualTo("+A");
    assertThat(diff.beside(5)).isEqualTo("+B");
    assertThat(diff.beside(6)).isEmpty();
    assertThat(diff.beside(7)).isEqualTo("-a");
    assertThat(diff.beside(8)).isEqualTo("-b");
  }
}
