package org.selectiverenderer.validation.report;

import java.util.Locale;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.Report;
import org.selectiverenderer.x3d.Problem.Severity;

/** For people: a line for each finding, as compilers write it, and a sum. */
public final class TextReport {
  private TextReport() {}

  public static String of(Report report) {
    StringBuilder text = new StringBuilder();
    for (Finding finding : report.findings()) {
      text.append(finding.location())
          .append(": ")
          .append(finding.severity().name().toLowerCase(Locale.ROOT))
          .append(": ")
          .append(finding.message())
          .append(" [")
          .append(finding.rule().id())
          .append("]\n");
    }
    return text.append(sum(report)).append('\n').toString();
  }

  private static String sum(Report report) {
    return count(report.files().size(), "file")
        + ": "
        + count(report.count(Severity.ERROR), "error")
        + ", "
        + count(report.count(Severity.WARNING), "warning")
        + ", "
        + count(report.count(Severity.INFO), "remark");
  }

  private static String count(int number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }
}
