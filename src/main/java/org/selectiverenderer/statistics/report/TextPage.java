package org.selectiverenderer.statistics.report;

import java.util.List;

/** Writes blocks as plain text, in lines of at most {@link TextLines#WIDTH} characters. */
final class TextPage {
  private final StringBuilder out = new StringBuilder();
  private final boolean details;

  private TextPage(boolean details) {
    this.details = details;
  }

  /**
   * Returns the text; its last line is terminated.
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
        TextLines.write(out, "", "", paragraph.text());
        out.append('\n');
      } else if (block instanceof Block.Items items) {
        items.texts().forEach(text -> TextLines.write(out, "- ", "  ", text));
        out.append('\n');
      } else if (block instanceof Block.Table table) {
        TextTable.write(out, table);
      }
    }
  }

  private void heading(String title, char line) {
    out.append(title).append('\n');
    out.append(String.valueOf(line).repeat(title.length())).append("\n\n");
  }
}
