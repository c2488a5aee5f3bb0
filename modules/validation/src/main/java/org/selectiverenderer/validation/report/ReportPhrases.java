package org.selectiverenderer.validation.report;

import java.util.Locale;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.ValidationReport;

/** Words and phrases that several formats use. */
final class ReportPhrases {
  private ReportPhrases() {}

  /** Returns {@code error}, {@code warning} or {@code info}. */
  static String of(Severity severity) {
    return severity.name().toLowerCase(Locale.ROOT);
  }

  /** Returns a number with its noun, in the plural where needed. */
  static String count(int number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }

  /** Returns the sentence that the report is incomplete. */
  static String dropped(ValidationReport report) {
    return "%d findings are not reported: more than %d of one rule in one file"
        .formatted(report.dropped(), FindingCollector.LIMIT);
  }
}
