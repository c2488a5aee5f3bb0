package org.selectiverenderer.validation.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationReport;

/**
 * Writes the report as JUnit XML for CI systems: each file is a test case, which fails if it has a
 * finding that makes the run fail; lesser findings are its output.
 */
final class JunitReportWriter {
  private JunitReportWriter() {}

  /**
   * @param failOn the least severity that makes a run fail
   */
  static String of(ValidationReport report, Severity failOn) {
    Map<String, List<Finding>> byFile = new LinkedHashMap<>();
    for (SourceFile file : report.files()) {
      byFile.put(file.name(), new ArrayList<>());
    }
    for (Finding finding : report.findings()) {
      byFile.computeIfAbsent(finding.location().file(), file -> new ArrayList<>()).add(finding);
    }
    long failed =
        byFile.values().stream()
            .filter(findings -> findings.stream().anyMatch(finding -> fails(finding, failOn)))
            .count();
    StringBuilder xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    xml.append(
        "<testsuites>\n  <testsuite name=\"validate\" tests=\"%d\" failures=\"%d\">\n"
            .formatted(byFile.size(), failed));
    byFile.forEach((file, findings) -> test(xml, file, findings, failOn));
    if (report.dropped() > 0) {
      xml.append("    <system-err>")
          .append(ReportPhrases.dropped(report))
          .append("</system-err>\n");
    }
    return xml.append("  </testsuite>\n</testsuites>\n").toString();
  }

  private static void test(
      StringBuilder xml, String file, List<Finding> findings, Severity failOn) {
    List<Finding> failures = findings.stream().filter(finding -> fails(finding, failOn)).toList();
    List<Finding> rest = findings.stream().filter(finding -> !fails(finding, failOn)).toList();
    xml.append("    <testcase classname=\"validate\" name=\"")
        .append(MarkupEscaper.attribute(file))
        .append('"');
    if (findings.isEmpty()) {
      xml.append("/>\n");
      return;
    }
    xml.append(">\n");
    if (!failures.isEmpty()) {
      xml.append("      <failure message=\"")
          .append(ReportPhrases.count(failures.size(), "finding"))
          .append("\" type=\"")
          .append(failures.get(0).rule().id())
          .append("\">")
          .append(MarkupEscaper.attribute(lines(failures)))
          .append("</failure>\n");
    }
    if (!rest.isEmpty()) {
      xml.append("      <system-out>")
          .append(MarkupEscaper.attribute(lines(rest)))
          .append("</system-out>\n");
    }
    xml.append("    </testcase>\n");
  }

  private static boolean fails(Finding finding, Severity failOn) {
    return finding.severity().compareTo(failOn) <= 0;
  }

  private static String lines(List<Finding> findings) {
    StringBuilder lines = new StringBuilder();
    for (Finding finding : findings) {
      lines
          .append(finding.location())
          .append(": ")
          .append(ReportPhrases.of(finding.severity()))
          .append(": ")
          .append(finding.message())
          .append(" [")
          .append(finding.rule().id())
          .append("]\n");
    }
    return lines.toString();
  }
}
