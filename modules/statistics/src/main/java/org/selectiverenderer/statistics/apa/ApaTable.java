package org.selectiverenderer.statistics.apa;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.formats.csv.CsvWriter;

/**
 * A table in APA style: lines above and below the header and below the last row, and none between
 * columns (Publication Manual, 7.17).
 *
 * @param name the ending of its file names, such as {@code effects}
 * @param title the title, in italics above the table
 * @param words how many columns from the left hold words; the others hold numbers
 * @param rows as long as the header
 * @param note the note below the table, empty for none
 */
public record ApaTable(
    String name,
    String title,
    List<String> header,
    int words,
    List<List<String>> rows,
    String note) {
  /** The statistics that the Publication Manual sets in italics. */
  private static final Set<String> ITALIC = Set.of("F", "p", "M", "SD", "SE", "n", "df", "t", "d");

  /** Makes defensive copies, so that the record is immutable. */
  public ApaTable {
    header = List.copyOf(header);
    rows = List.copyOf(rows);
  }

  /** Returns an HTML page with this table alone, which word processors can open and paste. */
  public String html() {
    StringBuilder out = new StringBuilder();
    out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>");
    out.append(MarkupEscaper.text(title)).append("</title>\n<style>\n");
    out.append("body { font-family: 'Times New Roman', serif; }\n");
    out.append("table { border-collapse: collapse; border-bottom: 1px solid; }\n");
    out.append("th, td { padding: 2px 10px; text-align: right; font-weight: normal; }\n");
    out.append("th { border-top: 1px solid; border-bottom: 1px solid; text-align: center; }\n");
    out.append(".words { text-align: left; }\n</style>\n</head>\n<body>\n");
    out.append("<p><i>").append(MarkupEscaper.text(title)).append("</i></p>\n<table>\n<tr>");
    header.forEach(cell -> out.append("<th>").append(htmlHead(cell)).append("</th>"));
    out.append("</tr>\n");
    for (List<String> row : rows) {
      out.append("<tr>");
      for (int i = 0; i < row.size(); i++) {
        out.append(i < words ? "<td class=\"words\">" : "<td>");
        out.append(MarkupEscaper.text(row.get(i))).append("</td>");
      }
      out.append("</tr>\n");
    }
    out.append("</table>\n");
    if (!note.isEmpty()) {
      out.append("<p><i>Note.</i> ").append(MarkupEscaper.text(note)).append("</p>\n");
    }
    return out.append("</body>\n</html>\n").toString();
  }

  private static String htmlHead(String cell) {
    return ITALIC.contains(cell) ? "<i>" + cell + "</i>" : MarkupEscaper.text(cell);
  }

  /**
   * Returns a LaTeX {@code table} with booktabs rules: {@code \input} it below {@code
   * \\usepackage{booktabs}}.
   */
  public String latex() {
    StringBuilder out = new StringBuilder();
    out.append("% needs \\usepackage{booktabs}\n\\begin{table}\n\\caption{");
    out.append(LatexEscaper.of(title)).append("}\n\\begin{tabular}{");
    out.append("l".repeat(words)).append("r".repeat(header.size() - words));
    out.append("}\n\\toprule\n");
    out.append(
        header.stream()
            .map(cell -> ITALIC.contains(cell) ? "\\textit{" + cell + "}" : LatexEscaper.of(cell))
            .collect(Collectors.joining(" & ", "", " \\\\\n\\midrule\n")));
    for (List<String> row : rows) {
      out.append(
          row.stream().map(LatexEscaper::of).collect(Collectors.joining(" & ", "", " \\\\\n")));
    }
    out.append("\\bottomrule\n\\end{tabular}\n");
    if (!note.isEmpty()) {
      out.append("\n\\smallskip\\textit{Note.} ").append(LatexEscaper.of(note)).append('\n');
    }
    return out.append("\\end{table}\n").toString();
  }

  /** Returns the cells as CSV, without title and note, and with hyphens for minus signs. */
  public String csv() {
    CsvWriter table = new CsvWriter().row(header);
    rows.forEach(row -> table.row(row.stream().map(cell -> cell.replace('−', '-')).toList()));
    return table.toString();
  }
}
