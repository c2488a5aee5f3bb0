package org.selectiverenderer.authoring.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.ThreeWayMerge.Choice;
import org.selectiverenderer.authoring.file.ThreeWayMerge.Kind;
import org.selectiverenderer.x3d.source.TextEdit;

class ThreeWayMergeTest {
  private static final String BASE = "a\nb\nc\nd\ne\n";

  @TempDir Path folder;

  private static ThreeWayMerge merge(String mine, String theirs) {
    return ThreeWayMerge.of(Optional.of(BASE), mine, theirs);
  }

  @Test
  void whatOneSideAloneHasChangedIsTaken() {
    ThreeWayMerge merge = merge("a\nB\nc\nd\ne\n", "a\nb\nc\nd\ne\nf\n");
    assertThat(merge.count(Kind.CONFLICT)).isZero();
    assertThat(merge.text(List.of())).isEqualTo("a\nB\nc\nd\ne\nf\n");
  }

  @Test
  void theSameChangeOnBothSidesIsNoConflict() {
    ThreeWayMerge merge = merge("a\nX\nc\nd\n", "a\nX\nc\nd\n");
    assertThat(merge.count(Kind.CONFLICT)).isZero();
    assertThat(merge.text(List.of())).isEqualTo("a\nX\nc\nd\n");
  }

  @Test
  void whatBothHaveChangedIsDecided() {
    ThreeWayMerge merge = merge("a\nmine\nc\nd\ne\n", "a\ntheirs\nc\nd\n");
    assertThat(merge.count(Kind.CONFLICT)).isEqualTo(1);
    assertThat(merge.text(List.of(Choice.MINE))).isEqualTo("a\nmine\nc\nd\n");
    assertThat(merge.text(List.of(Choice.THEIRS))).isEqualTo("a\ntheirs\nc\nd\n");
    assertThat(merge.text(List.of(Choice.MINE_FIRST))).isEqualTo("a\nmine\ntheirs\nc\nd\n");
    assertThat(merge.text(List.of(Choice.THEIRS_FIRST))).isEqualTo("a\ntheirs\nmine\nc\nd\n");
  }

  @Test
  void withoutACommonTextEveryDifferenceIsDecided() {
    ThreeWayMerge merge = ThreeWayMerge.of(Optional.empty(), "a\nb\nc\n", "a\nx\nc\nd");
    assertThat(merge.count(Kind.CONFLICT)).isEqualTo(2);
    assertThat(merge.text(List.of(Choice.THEIRS, Choice.MINE_FIRST))).isEqualTo("a\nx\nc\nd");
  }

  @Test
  void aLastLineWithoutAnEndGetsOneBeforeOthers() {
    ThreeWayMerge merge = merge("a\nb\nc\nd\nmine", "a\nb\nc\nd\ntheirs");
    assertThat(merge.text(List.of(Choice.MINE_FIRST))).isEqualTo("a\nb\nc\nd\nmine\ntheirs");
  }

  @Test
  void linesThatEndAsThoseOfAnotherSystemAreTheSame() {
    ThreeWayMerge merge = merge("a\nB\nc\nd\ne\n", "a\r\nb\r\nc\r\nd\r\nE\r\n");
    assertThat(merge.text(List.of())).isEqualTo("a\nB\nc\nd\nE\n");
  }

  @Test
  void whateverTheTextsAreOneSideTakenEverywhereIsThatSide() {
    Random random = new Random(4);
    for (int i = 0; i < 300; i++) {
      String base = lines(random);
      String mine = lines(random);
      String theirs = lines(random);
      ThreeWayMerge merge = ThreeWayMerge.of(Optional.of(base), mine, theirs);
      StringBuilder here = new StringBuilder();
      StringBuilder there = new StringBuilder();
      merge.parts().forEach(part -> here.append(part.mine()));
      merge.parts().forEach(part -> there.append(part.theirs()));
      assertThat(here.toString()).isEqualTo(mine);
      assertThat(there.toString()).isEqualTo(theirs);
      List<Choice> all = java.util.Collections.nCopies(merge.count(Kind.CONFLICT), Choice.THEIRS);
      assertThat(TextEdit.applied(merge.edit("m", all).changes(), mine).toString())
          .isEqualTo(merge.text(all));
      assertThat(ThreeWayMerge.of(Optional.of(mine), mine, theirs).text(List.of()))
          .isEqualTo(theirs);
    }
  }

  private static String lines(Random random) {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(12); i > 0; i--) {
      text.append((char) ('a' + random.nextInt(5))).append('\n');
    }
    return text.toString();
  }

  @Test
  void whatIsTakenIsOneStepAndSavingReplacesItWithoutAsking() throws IOException {
    Path file = Files.writeString(folder.resolve("a.x3d"), "<X3D>\n<Scene/>\n</X3D>\n");
    DocumentFile open = DocumentFile.open(file);
    SceneDocument document = open.document();
    document.type(0, 0, "<!-- mine -->\n");
    String mine = document.text().toString();
    Files.writeString(file, "<X3D>\n<Scene/>\n</X3D>\n<!-- theirs -->\n");
    ExternalFileVersion theirs = ExternalFileVersion.read(file);
    assertThat(theirs.sameForm(document.snapshot())).isTrue();
    ThreeWayMerge merge = ThreeWayMerge.of(open.common(), mine, theirs.text());
    open.take(theirs, merge.edit("Merge", List.of()));
    assertThat(document.history().undoName()).contains("Merge");
    assertThat(document.modified()).isTrue();
    open.save();
    assertThat(file).hasContent("<!-- mine -->\n<X3D>\n<Scene/>\n</X3D>\n<!-- theirs -->\n");
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(mine);
  }
}
