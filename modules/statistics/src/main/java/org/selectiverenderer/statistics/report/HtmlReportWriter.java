package org.selectiverenderer.statistics.report;

import java.util.List;
import org.selectiverenderer.base.markup.MarkupEscaper;

/** Writes blocks as one self-contained HTML page, with its style and pictures inside. */
final class HtmlReportWriter {
  private static final String STYLE =
      """
      body { font: 15px/1.45 'DejaVu Sans', Verdana, sans-serif; color: #222; max-width: 72rem;
        margin: 2rem auto; padding: 0 1rem; }
      p, ul { max-width: 62rem; }
      h1 { font-size: 1.6rem; } h2 { font-size: 1.3rem; margin-top: 2.2rem; border-bottom: 1px solid #ccc; }
      h3 { font-size: 1.1rem; } h4 { font-size: 1rem; }
      table { border-collapse: collapse; margin: 1rem 0; font-size: 13px; }
      caption { text-align: left; font-weight: bold; padding: .3rem 0; }
      th, td { padding: .22rem .45rem; text-align: right; white-space: nowrap; }
      th:first-child, td:first-child { text-align: left; }
      th.name, td.name { text-align: left; }
      td.words { white-space: normal; text-align: left; }
      thead th { border-top: 2px solid #222; border-bottom: 1px solid #222; }
      tbody tr:last-child td { border-bottom: 2px solid #222; }
      tr.part td { font-style: italic; text-align: left; border-top: 1px solid #999; padding-top: .5rem; }
      p.note { font-size: 12px; margin: .1rem 0; color: #444; }
      .wide { overflow-x: auto; margin-bottom: 1rem; }
      figure { display: inline-block; margin: .5rem 1rem .5rem 0; vertical-align: top; }
      figcaption { font-size: 12px; color: #444; max-width: 460px; }
      details { margin: .6rem 0; border-left: 3px solid #ddd; padding-left: .8rem; }
      summary { cursor: pointer; font-weight: bold; }
      @media print { body { max-width: none; font-size: 11px; } table { font-size: 9px; }
        .wide { overflow: visible; } figure, tr { break-inside: avoid; } }
      """;

  /** Cells with more characters than this may wrap between words. */
  private static final int LONG = 45;

  private final StringBuilder out = new StringBuilder();

  private HtmlReportWriter() {}

  static String of(String title, List<ReportBlock> blocks) {
    HtmlReportWriter page = new HtmlReportWriter();
    page.out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    page.out.append("<title>").append(MarkupEscaper.attribute(title)).append("</title>\n");
    page.out.append("<style>\n").append(STYLE).append("</style>\n</head>\n<body>\n");
    page.out.append("<h1>").append(MarkupEscaper.attribute(title)).append("</h1>\n");
    page.write(blocks, 2);
    return page.out.append("</body>\n</html>\n").toString();
  }

  private void write(List<ReportBlock> blocks, int level) {
    for (ReportBlock block : blocks) {
      if (block instanceof ReportBlock.Section section) {
        section(section, level);
      } else if (block instanceof ReportBlock.Paragraph paragraph) {
        out.append("<p>").append(MarkupEscaper.attribute(paragraph.text())).append("</p>\n");
      } else if (block instanceof ReportBlock.Items items) {
        out.append("<ul>\n");
        items
            .texts()
            .forEach(
                text -> out.append("<li>").append(MarkupEscaper.attribute(text)).append("</li>\n"));
        out.append("</ul>\n");
      } else if (block instanceof ReportBlock.Table table) {
        table(table);
      } else if (block instanceof ReportBlock.Picture picture) {
        out.append("<figure>\n").append(picture.svg()).append("<figcaption>");
        out.append(MarkupEscaper.attribute(picture.caption())).append("</figcaption>\n</figure>\n");
      }
    }
  }

  private void section(ReportBlock.Section section, int level) {
    if (section.detail()) {
      out.append("<details><summary>")
          .append(MarkupEscaper.attribute(section.title()))
          .append("</summary>\n");
      write(section.blocks(), level + 1);
      out.append("</details>\n");
    } else {
      String tag = "h" + Math.min(level, 6);
      out.append('<').append(tag).append('>').append(MarkupEscaper.attribute(section.title()));
      out.append("</").append(tag).append(">\n");
      write(section.blocks(), level + 1);
    }
  }

  private void table(ReportBlock.Table table) {
    out.append("<div class=\"wide\">\n<table>\n<caption>")
        .append(MarkupEscaper.attribute(table.caption()));
    out.append("</caption>\n<thead><tr>");
    for (int i = 0; i < table.header().size(); i++) {
      out.append(table.words(i) ? "<th class=\"name\">" : "<th>");
      out.append(MarkupEscaper.attribute(table.header().get(i))).append("</th>");
    }
    out.append("</tr></thead>\n<tbody>\n");
    for (List<String> row : table.rows()) {
      boolean part = row.size() == 1 && table.header().size() > 1;
      out.append(part ? "<tr class=\"part\">" : "<tr>");
      for (int i = 0; i < row.size(); i++) {
        String span = part ? " colspan=\"" + table.header().size() + "\"" : "";
        String style =
            row.get(i).length() > LONG
                ? " class=\"words\""
                : !part && table.words(i) ? " class=\"name\"" : "";
        out.append("<td").append(span).append(style).append('>');
        out.append(MarkupEscaper.attribute(row.get(i))).append("</td>");
      }
      out.append("</tr>\n");
    }
    out.append("</tbody>\n</table>\n");
    table
        .notes()
        .forEach(
            note ->
                out.append("<p class=\"note\">")
                    .append(MarkupEscaper.attribute(note))
                    .append("</p>\n"));
    out.append("</div>\n");
  }
}
