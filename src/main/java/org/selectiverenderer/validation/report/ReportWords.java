package org.selectiverenderer.validation.report;

import java.util.Locale;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.Report;

/** Words that several formats use. */
final class ReportWords {
  private ReportWords() {}

  /** error, warning or info. */
  static String of(Severity severity) {
    return severity.name().toLowerCase(Locale.ROOT);
  }

  /** A number of things. */
  static String count(int number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }

  /** Says that a report is not complete. */
  static String dropped(Report report) {
    return "%d findings beyond %d of a rule and a file are not reported"
        .formatted(report.dropped(), Findings.LIMIT);
  }
}
