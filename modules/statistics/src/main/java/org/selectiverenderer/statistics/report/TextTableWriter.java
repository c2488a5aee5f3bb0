package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Writes a table as text. Where the table is too wide for the page, the cells of its longest column
 * of words are wrapped; columns that still do not fit follow below, with the columns that name the
 * rows repeated.
 */
final class TextTableWriter {
  private static final int LEAST_WORDS = 40;

  private final ReportBlock.Table table;
  private final int[] widths;
  private final StringBuilder out;

  private TextTableWriter(ReportBlock.Table table, StringBuilder out) {
    this.table = table;
    this.out = out;
    widths = new int[table.header().size()];
    widen(table.header());
    table.rows().forEach(this::widen);
  }

  /** Appends the caption, the rows, the notes and an empty line. */
  static void write(StringBuilder out, ReportBlock.Table table) {
    TextTableWriter text = new TextTableWriter(table, out);
    LineWrapper.write(out, "", "", table.caption());
    text.breakWords();
    text.parts().forEach(text::rows);
    table.notes().forEach(note -> LineWrapper.write(out, "  ", "  ", note));
    out.append('\n');
  }

  private void widen(List<String> row) {
    for (int i = 0; row.size() == widths.length && i < widths.length; i++) {
      widths[i] = Math.max(widths[i], row.get(i).length());
    }
  }

  private void breakWords() {
    int longest =
        IntStream.range(0, widths.length)
            .filter(table::words)
            .reduce((a, b) -> widths[b] > widths[a] ? b : a)
            .orElse(-1);
    int over = 1 + IntStream.of(widths).map(width -> width + 2).sum() - LineWrapper.WIDTH;
    if (longest > 0 && over > 0 && widths[longest] > LEAST_WORDS) {
      widths[longest] = Math.max(LEAST_WORDS, widths[longest] - over);
    }
  }

  /** Splits the columns into as few parts as fit the page, of about the same width. */
  private List<List<Integer>> parts() {
    List<List<Integer>> parts = parts(LineWrapper.WIDTH);
    // Where each column has a part of its own, no width makes more of them.
    for (int width = LineWrapper.WIDTH - 1; parts.size() > 1 && width > 0; width--) {
      List<List<Integer>> narrower = parts(width);
      if (narrower.size() > parts.size()) {
        break;
      }
      parts = narrower;
    }
    return parts;
  }

  private List<List<Integer>> parts(int width) {
    List<Integer> names =
        IntStream.range(0, widths.length - 1)
            .takeWhile(column -> column == 0 || table.words(column))
            .boxed()
            .toList();
    int named = 1 + names.stream().mapToInt(column -> widths[column] + 2).sum();
    List<List<Integer>> parts = new ArrayList<>();
    List<Integer> part = new ArrayList<>(names);
    int used = named;
    for (int column = names.size(); column < widths.length; column++) {
      // The last column has no padding.
      if (used + widths[column] + 1 > width && part.size() > names.size()) {
        parts.add(part);
        part = new ArrayList<>(names);
        used = named;
      }
      part.add(column);
      used += widths[column] + 2;
    }
    parts.add(part);
    return parts;
  }

  private void rows(List<Integer> columns) {
    row(table.header(), columns);
    table.rows().forEach(row -> row(row, columns));
  }

  private void row(List<String> row, List<Integer> columns) {
    if (row.size() < widths.length) {
      LineWrapper.write(out, "  ", "  ", row.get(0));
      return;
    }
    List<List<String>> cells =
        columns.stream().map(column -> LineWrapper.of(row.get(column), widths[column])).toList();
    int lines = cells.stream().mapToInt(List::size).max().orElse(1);
    for (int line = 0; line < lines; line++) {
      StringBuilder text = new StringBuilder(" ");
      for (int i = 0; i < cells.size(); i++) {
        String cell = line < cells.get(i).size() ? cells.get(i).get(line) : "";
        String pad = " ".repeat(Math.max(0, widths[columns.get(i)] - cell.length()));
        boolean left = columns.get(i) == 0 || table.words(columns.get(i));
        text.append(' ').append(left ? cell + pad : pad + cell).append(' ');
      }
      out.append(text.toString().stripTrailing()).append('\n');
    }
  }
}
