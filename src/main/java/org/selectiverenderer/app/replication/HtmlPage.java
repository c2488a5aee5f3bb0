package org.selectiverenderer.app.replication;

import java.util.List;
import org.selectiverenderer.base.markup.MarkupEscaper;

/** Puts together a page of headings, paragraphs, figures and tables, which loads nothing else. */
final class HtmlPage {
  private static final String STYLE =
      """
      :root { color-scheme: light dark; --ink: #222; --faint: #555; --paper: #fff; --line: #ccc;
        --good: #00664a; --off: #a04000; }
      body { font: 15px/1.5 'DejaVu Sans', Verdana, sans-serif; color: var(--ink);
        background: var(--paper); max-width: 74rem; margin: 2rem auto; padding: 0 1rem; }
      p, ul { max-width: 62rem; }
      h1 { font-size: 1.6rem; } h2 { font-size: 1.3rem; margin-top: 2.2rem;
        border-bottom: 1px solid var(--line); } h3 { font-size: 1.05rem; }
      table { border-collapse: collapse; margin: .8rem 0; font-size: 13px; }
      th, td { padding: .22rem .5rem; text-align: right; vertical-align: top; }
      th:first-child, td:first-child, td.words, th.words { text-align: left; }
      thead th { border-top: 2px solid var(--ink); border-bottom: 1px solid var(--ink); }
      tbody tr:last-child td { border-bottom: 2px solid var(--ink); }
      td.off { color: var(--off); font-weight: bold; } td.good { color: var(--good); }
      .wide { overflow-x: auto; } .note { font-size: 13px; color: var(--faint); }
      figure { display: inline-block; margin: .4rem .8rem .4rem 0; } svg { max-width: 100%; height: auto; }
      @media (prefers-color-scheme: dark) {
        :root { --ink: #e6e6e6; --faint: #b4b4b4; --paper: #16181b; --line: #44484d; --good: #62d2ad;
          --off: #ffa366; }
        a { color: #8cc4ff; }
        svg [fill="#ffffff"] { fill: #16181b; } svg [fill="#222222"] { fill: #e6e6e6; }
        svg [fill="#5a5a5a"] { fill: #b4b4b4; } svg [fill="#dddddd"] { fill: #33373c; }
      }
      @media print { :root { --ink: #000; --paper: #fff; } body { max-width: none; font-size: 11px; }
        table { font-size: 9px; } .wide { overflow: visible; } figure, tr { break-inside: avoid; } }
      """;

  private final StringBuilder out = new StringBuilder();

  HtmlPage(String title) {
    out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
        .append("<meta name=\"viewport\" content=\"width=device-width\">\n<title>")
        .append(title)
        .append("</title>\n<style>\n")
        .append(STYLE)
        .append("</style>\n</head>\n<body>\n<h1>")
        .append(title)
        .append("</h1>\n");
  }

  /** Returns the whole page; nothing can be added afterwards. */
  String close() {
    return out.append("</body>\n</html>\n").toString();
  }

  void heading(String text) {
    out.append("<h2>").append(text).append("</h2>\n");
  }

  void paragraph(String text) {
    out.append("<p>").append(MarkupEscaper.attribute(text)).append("</p>\n");
  }

  /** Adds a remark to what stands above it. */
  void note(String text) {
    out.append("<p class=\"note\">").append(MarkupEscaper.attribute(text)).append("</p>\n");
  }

  /** Adds the title of a table. */
  void tableTitle(String text) {
    out.append("<h3>").append(MarkupEscaper.attribute(text)).append("</h3>\n");
  }

  void figure(String svg) {
    out.append("<figure>").append(svg).append("</figure>\n");
  }

  /** Adds markup as it is. */
  void markup(String text) {
    out.append(text);
  }

  /**
   * Adds a table.
   *
   * @param rows cells in markup, from {@link #cell}, {@link #words}, {@link #good} or {@link #off};
   *     a column whose first cell holds words is set to the left
   */
  void table(List<String> header, List<List<String>> rows) {
    out.append("<div class=\"wide\"><table>\n<thead><tr>");
    for (int i = 0; i < header.size(); i++) {
      boolean words = rows.get(0).get(i).contains("\"words\"");
      out.append(words ? "<th class=\"words\">" : "<th>").append(header.get(i)).append("</th>");
    }
    out.append("</tr></thead>\n<tbody>\n");
    for (List<String> row : rows) {
      out.append("<tr>");
      row.forEach(out::append);
      out.append("</tr>\n");
    }
    out.append("</tbody>\n</table></div>\n");
  }

  /** Returns the markup of a cell with a number. */
  static String cell(String text) {
    return "<td>" + MarkupEscaper.attribute(text) + "</td>";
  }

  /** Returns the markup of a cell with words. */
  static String words(String text) {
    return "<td class=\"words\">" + MarkupEscaper.attribute(text) + "</td>";
  }

  /** Returns the markup of a cell that is as it should be. */
  static String good(String text) {
    return "<td class=\"good\">" + MarkupEscaper.attribute(text) + "</td>";
  }

  /** Returns the markup of a cell that is not as it should be. */
  static String off(String text) {
    return "<td class=\"off\">" + MarkupEscaper.attribute(text) + "</td>";
  }
}
