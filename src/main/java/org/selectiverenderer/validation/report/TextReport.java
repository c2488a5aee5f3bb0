package org.selectiverenderer.validation.report;

import java.util.Optional;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.Report;
import org.selectiverenderer.validation.SourceExcerpts;
import org.selectiverenderer.x3d.Problem.Severity;

/**
 * For people, as compilers write it: a line for each finding that editors and terminals link, the
 * line of the file, a caret at the place; and a sum.
 */
final class TextReport {
  private static final String END = "\u001b[0m";
  private static final String BOLD = "\u001b[1m";
  private static final String GREEN = "\u001b[1;32m";

  private final boolean colours;

  TextReport(boolean colours) {
    this.colours = colours;
  }

  String of(Report report) {
    StringBuilder text = new StringBuilder();
    SourceExcerpts excerpts = new SourceExcerpts(report.files());
    for (Finding finding : report.findings()) {
      text.append(in(BOLD, finding.location() + ":"))
          .append(' ')
          .append(in(colour(finding.severity()), Words.of(finding.severity()) + ":"))
          .append(' ')
          .append(in(BOLD, finding.message()))
          .append(" [")
          .append(finding.rule().id())
          .append("]\n");
      Optional<SourceExcerpts.Excerpt> excerpt = excerpts.at(finding.location());
      excerpt.ifPresent(
          found ->
              text.append("  ")
                  .append(found.text())
                  .append("\n  ")
                  .append(found.before())
                  .append(in(GREEN, "^"))
                  .append('\n'));
    }
    return text.append(sum(report)).append('\n').toString();
  }

  private String in(String colour, String text) {
    return colours ? colour + text + END : text;
  }

  private static String colour(Severity severity) {
    return switch (severity) {
      case ERROR -> "\u001b[1;31m";
      case WARNING -> "\u001b[1;35m";
      case INFO -> "\u001b[1;36m";
    };
  }

  private static String sum(Report report) {
    return Words.count(report.files().size(), "file")
        + ": "
        + Words.count(report.count(Severity.ERROR), "error")
        + ", "
        + Words.count(report.count(Severity.WARNING), "warning")
        + ", "
        + Words.count(report.count(Severity.INFO), "remark");
  }
}
