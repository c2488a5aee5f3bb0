package org.selectiverenderer.statistics.report;

import java.util.List;

/** Writes blocks as plain text, in lines of at most {@link LineWrapper#WIDTH} characters. */
final class TextReportWriter {
  private final StringBuilder out = new StringBuilder();
  private final boolean details;

  private TextReportWriter(boolean details) {
    this.details = details;
  }

  /**
   * Returns the text; its last line is terminated.
   *
   * @param details whether sections of details are written
   */
  static String of(String title, List<ReportBlock> blocks, boolean details) {
    TextReportWriter page = new TextReportWriter(details);
    page.heading(title, '=');
    page.write(blocks, 0);
    return page.out.toString();
  }

  private void write(List<ReportBlock> blocks, int depth) {
    for (ReportBlock block : blocks) {
      if (block instanceof ReportBlock.Section section) {
        if (details || !section.detail()) {
          heading(section.title(), depth == 0 ? '-' : '.');
          write(section.blocks(), depth + 1);
        }
      } else if (block instanceof ReportBlock.Paragraph paragraph) {
        LineWrapper.write(out, "", "", paragraph.text());
        out.append('\n');
      } else if (block instanceof ReportBlock.Items items) {
        items.texts().forEach(text -> LineWrapper.write(out, "- ", "  ", text));
        out.append('\n');
      } else if (block instanceof ReportBlock.Table table) {
        TextTableWriter.write(out, table);
      }
    }
  }

  private void heading(String title, char line) {
    out.append(title).append('\n');
    out.append(String.valueOf(line).repeat(title.length())).append("\n\n");
  }
}
