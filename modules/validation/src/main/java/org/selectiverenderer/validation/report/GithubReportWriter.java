package org.selectiverenderer.validation.report;

import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.ValidationReport;

/**
 * Writes the report as workflow commands of GitHub Actions, which annotate the lines of a pull
 * request.
 */
final class GithubReportWriter {
  private GithubReportWriter() {}

  static String of(ValidationReport report) {
    StringBuilder text = new StringBuilder();
    for (Finding finding : report.findings()) {
      Severity severity = finding.severity();
      text.append("::")
          .append(severity == Severity.INFO ? "notice" : ReportPhrases.of(severity))
          .append(" file=")
          .append(property(finding.location().file()));
      if (finding.location().line() > 0) {
        text.append(",line=").append(finding.location().line());
      }
      if (finding.location().column() > 0) {
        text.append(",col=").append(finding.location().column());
      }
      text.append(",title=")
          .append(finding.rule().id())
          .append("::")
          .append(data(finding.message()))
          .append('\n');
    }
    if (report.dropped() > 0) {
      text.append("::warning::").append(ReportPhrases.dropped(report)).append('\n');
    }
    return text.toString();
  }

  private static String data(String text) {
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A");
  }

  private static String property(String text) {
    return data(text).replace(":", "%3A").replace(",", "%2C");
  }
}
