package org.selectiverenderer.validation.report;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.ValidationReport;

/**
 * Writes the report as text in the style of compilers: a line for each finding, which editors and
 * terminals can link, the source line with a caret at the location, and a summary. At most {@value
 * #LISTED} findings of one rule in one file are listed.
 */
final class TextReportWriter {
  private static final int LISTED = 50;

  private static final String END = "\u001b[0m";
  private static final String BOLD = "\u001b[1m";
  private static final String GREEN = "\u001b[1;32m";

  /** Identifies the findings of one rule in one file. */
  private record Many(String file, String rule) {}

  private final boolean colours;

  TextReportWriter(boolean colours) {
    this.colours = colours;
  }

  String of(ValidationReport report) {
    StringBuilder text = new StringBuilder();
    SourceSnippets excerpts = new SourceSnippets(report.files());
    Map<Many, Integer> counts = new LinkedHashMap<>();
    for (Finding finding : report.findings()) {
      Many many = new Many(finding.location().file(), finding.rule().id());
      if (counts.merge(many, 1, Integer::sum) > LISTED) {
        continue;
      }
      text.append(in(BOLD, finding.location() + ":"))
          .append(' ')
          .append(in(colour(finding.severity()), ReportPhrases.of(finding.severity()) + ":"))
          .append(' ')
          .append(in(BOLD, finding.message()))
          .append(" [")
          .append(finding.rule().id())
          .append("]\n");
      Optional<SourceSnippets.Snippet> excerpt = excerpts.at(finding.location());
      excerpt.ifPresent(
          found ->
              text.append("  ")
                  .append(found.text())
                  .append("\n  ")
                  .append(found.before())
                  .append(in(GREEN, "^"))
                  .append('\n'));
    }
    counts.forEach(
        (many, count) -> {
          if (count > LISTED) {
            text.append(in(BOLD, ControlCharacterEscaper.line(many.file) + ":"))
                .append(" %d more of %s are not listed".formatted(count - LISTED, many.rule))
                .append(" (--format json lists all)\n");
          }
        });
    if (report.dropped() > 0) {
      text.append(ReportPhrases.dropped(report)).append('\n');
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

  private static String sum(ValidationReport report) {
    return ReportPhrases.count(report.files().size(), "file")
        + ": "
        + ReportPhrases.count(report.count(Severity.ERROR), "error")
        + ", "
        + ReportPhrases.count(report.count(Severity.WARNING), "warning")
        + ", "
        + ReportPhrases.count(report.count(Severity.INFO), "remark");
  }
}
