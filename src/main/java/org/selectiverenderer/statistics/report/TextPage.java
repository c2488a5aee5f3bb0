package org.selectiverenderer.statistics.report;

import java.util.List;

/** Writes blocks as plain text, tables with columns below each other. */
final class TextPage {
  private final StringBuilder out = new StringBuilder();
  private final boolean details;

  private TextPage(boolean details) {
    this.details = details;
  }

  /**
   * Lines, the last one ended.
   *
   * @param details whether sections of details are written
   */
  static String of(String title, List<Block> blocks, boolean details) {
    TextPage page = new TextPage(details);
    page.heading(title, '=');
    page.write(blocks, 0);
    return page.out.toString();
  }

  private void write(List<Block> blocks, int depth) {
    for (Block block : blocks) {
      if (block instanceof Block.Section section) {
        if (details || !section.detail()) {
          heading(section.title(), depth == 0 ? '-' : '.');
          write(section.blocks(), depth + 1);
        }
      } else if (block instanceof Block.Paragraph paragraph) {
        out.append(paragraph.text()).append("\n\n");
      } else if (block instanceof Block.Items items) {
        items.texts().forEach(text -> out.append("- ").append(text).append('\n'));
        out.append('\n');
      } else if (block instanceof Block.Table table) {
        table(table);
      }
    }
  }

  private void heading(String title, char line) {
    out.append(title).append('\n');
    out.append(String.valueOf(line).repeat(title.length())).append("\n\n");
  }

  private void table(Block.Table table) {
    out.append(table.caption()).append('\n');
    int[] widths = new int[table.header().size()];
    widen(widths, table.header());
    table.rows().forEach(row -> widen(widths, row));
    row(table, table.header(), widths);
    for (List<String> row : table.rows()) {
      row(table, row, widths);
    }
    table.notes().forEach(note -> out.append("  ").append(note).append('\n'));
    out.append('\n');
  }

  private static void widen(int[] widths, List<String> row) {
    for (int i = 0; row.size() == widths.length && i < widths.length; i++) {
      widths[i] = Math.max(widths[i], row.get(i).length());
    }
  }

  private void row(Block.Table table, List<String> row, int[] widths) {
    StringBuilder line = new StringBuilder(" ");
    for (int i = 0; i < row.size(); i++) {
      String pad = " ".repeat(Math.max(0, widths[i] - row.get(i).length()));
      line.append(' ')
          .append(i == 0 || table.words(i) ? row.get(i) + pad : pad + row.get(i))
          .append(' ');
    }
    out.append(line.toString().stripTrailing()).append('\n');
  }
}
