package org.selectiverenderer.statistics.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class TextReportWriterTest {
  private static final String LONG = "a sentence of seven words is repeated ".repeat(10).strip();

  @Test
  void paragraphsItemsAndNotesAreBrokenBetweenWords() {
    String text =
        TextReportWriter.of(
            "Title",
            List.of(
                new ReportBlock.Paragraph(LONG),
                new ReportBlock.Items(List.of(LONG, "short")),
                new ReportBlock.Table(
                    "caption", List.of("a"), List.of(List.of("1")), List.of(LONG))),
            true);
    assertThat(text.lines()).allSatisfy(line -> assertThat(line).hasSizeLessThanOrEqualTo(120));
    assertThat(text.replaceAll("\\s+", " ")).contains("- " + LONG, "- short", "1 " + LONG);
    assertThat(text.lines().filter(line -> line.startsWith("- "))).hasSize(2);
  }

  /** The first column names the rows of what follows below. */
  @Test
  void aTableThatIsTooWideGoesOnBelow() {
    List<String> header = new ArrayList<>(List.of("name"));
    List<String> row = new ArrayList<>(List.of("one"));
    for (int i = 0; i < 12; i++) {
      header.add("a column " + i);
      row.add("1234567890." + i);
    }
    String text =
        TextReportWriter.of(
            "T",
            List.of(
                new ReportBlock.Table(
                    "caption", header, List.of(List.of("a part"), row), List.of("note"))),
            true);
    List<String> lines = text.lines().toList();
    assertThat(lines).allSatisfy(line -> assertThat(line).hasSizeLessThanOrEqualTo(120));
    assertThat(lines.stream().filter(line -> line.startsWith("  name "))).hasSize(2);
    assertThat(lines.stream().filter(line -> line.startsWith("  one "))).hasSize(2);
    assertThat(lines.stream().filter(line -> line.equals("  a part"))).hasSize(2);
    assertThat(lines.stream().filter(line -> line.equals("caption"))).hasSize(1);
    for (int i = 0; i < 12; i++) {
      assertThat(text).containsOnlyOnce("a column " + i + (i == 1 ? " " : ""));
      assertThat(text).containsOnlyOnce("1234567890." + i + (i == 1 ? " " : ""));
    }
  }

  /** A path may be longer than a line, and then each further column is a part of its own. */
  @Test
  @Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void aNameThatIsLongerThanALineEnds() {
    String path = "/home/" + "folder/".repeat(30) + "d.csv:9:9";
    String text =
        TextReportWriter.of(
            "T",
            List.of(
                new ReportBlock.Table(
                    "caption",
                    List.of("place", "one", "two"),
                    List.of(List.of(path, "1", "2")),
                    List.of())),
            true);
    assertThat(text).contains("d.csv:9:9", "one", "two");
  }

  @Test
  void aLongColumnOfWordsIsBrokenIntoLinesBesideTheOthers() {
    String text =
        TextReportWriter.of(
            "T",
            List.of(
                new ReportBlock.Table(
                    "caption",
                    List.of("place", "what", "n"),
                    List.of(List.of("r.csv:2:1", LONG, "7"), List.of("r.csv:3:1", "short", "8")),
                    List.of())),
            true);
    List<String> lines = text.lines().toList();
    assertThat(lines).allSatisfy(line -> assertThat(line).hasSizeLessThanOrEqualTo(120));
    assertThat(lines.stream().filter(line -> line.contains("r.csv:2:1"))).hasSize(1);
    assertThat(lines.stream().filter(line -> line.contains("place"))).hasSize(1);
    assertThat(text.replace(" 7\n", "\n").replaceAll("\\s+", " ")).contains(LONG);
  }
}
