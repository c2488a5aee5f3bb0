package org.selectiverenderer.statistics.report;

import java.util.List;

/** A block element of a report, independent of the output format. */
sealed interface ReportBlock {
  /**
   * A section: blocks under a heading.
   *
   * @param detail whether the section has details that a reader may skip: it is folded in HTML and
   *     left out of text
   */
  record Section(String title, boolean detail, List<ReportBlock> blocks) implements ReportBlock {
    public Section {
      blocks = List.copyOf(blocks);
    }
  }

  /** A paragraph. */
  record Paragraph(String text) implements ReportBlock {}

  /** A list of sentences. */
  record Items(List<String> texts) implements ReportBlock {
    public Items {
      texts = List.copyOf(texts);
    }
  }

  /**
   * A table.
   *
   * @param rows as long as the header; a row of one cell is a heading within the table
   * @param notes footnotes below the table
   */
  record Table(String caption, List<String> header, List<List<String>> rows, List<String> notes)
      implements ReportBlock {
    public Table {
      header = List.copyOf(header);
      rows = List.copyOf(rows);
      notes = List.copyOf(notes);
    }

    /** Returns whether a column holds words, which are aligned left, and not numbers. */
    boolean words(int column) {
      return rows.stream()
          .filter(row -> row.size() == header.size())
          .map(row -> row.get(column))
          .allMatch(cell -> cell.matches("[\\p{L}'].*") && !cell.startsWith("F("));
    }
  }

  /**
   * An SVG picture; text reports leave it out.
   *
   * @param svg an SVG element
   */
  record Picture(String caption, String svg) implements ReportBlock {}
}
