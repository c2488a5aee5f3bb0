package org.selectiverenderer.statistics.report;

import java.util.List;

/** A part of a report. */
sealed interface Block {
  /**
   * A part with a heading.
   *
   * @param detail whether a reader may want to pass over it: folded in HTML, left out of text
   */
  record Section(String title, boolean detail, List<Block> blocks) implements Block {
    public Section {
      blocks = List.copyOf(blocks);
    }
  }

  /** A paragraph. */
  record Paragraph(String text) implements Block {}

  /** Sentences, one below the other. */
  record Items(List<String> texts) implements Block {
    public Items {
      texts = List.copyOf(texts);
    }
  }

  /**
   * A table.
   *
   * @param rows as long as the header; a row of one cell is a heading within the table
   * @param notes below it
   */
  record Table(String caption, List<String> header, List<List<String>> rows, List<String> notes)
      implements Block {
    public Table {
      header = List.copyOf(header);
      rows = List.copyOf(rows);
      notes = List.copyOf(notes);
    }

    /** Whether a column holds words, which are set to the left, and not figures. */
    boolean words(int column) {
      return rows.stream()
          .filter(row -> row.size() == header.size())
          .map(row -> row.get(column))
          .allMatch(cell -> cell.matches("[\\p{L}'].*") && !cell.startsWith("F("));
    }
  }

  /**
   * A drawing; text reports leave it out.
   *
   * @param svg an element
   */
  record Picture(String caption, String svg) implements Block {}
}
