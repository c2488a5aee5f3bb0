package org.selectiverenderer.validation.report;

import java.util.function.BiFunction;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.ValidationReport;

/** The report formats of {@code --format}. */
public enum ReportFormat {
  /** Plain text for people. */
  TEXT((report, style) -> new TextReportWriter(style.colours()).of(report)),
  /** JSON for programs; the schema is {@code report.schema.json} beside this class. */
  JSON((report, style) -> JsonReportWriter.of(report)),
  /** SARIF 2.1.0, for code scanning services. */
  SARIF((report, style) -> SarifReportWriter.of(report, style)),
  /** JUnit XML, for CI systems that show test results. */
  JUNIT((report, style) -> JunitReportWriter.of(report, style.failOn())),
  /** Annotations of GitHub Actions. */
  GITHUB((report, style) -> GithubReportWriter.of(report));

  /**
   * Parameters that some formats need besides the report.
   *
   * @param colours whether to use terminal colours
   * @param failOn the least severity that makes a run fail
   * @param version version of the program
   */
  public record Style(boolean colours, Severity failOn, String version) {}

  private final BiFunction<ValidationReport, Style, String> writer;

  ReportFormat(BiFunction<ValidationReport, Style, String> writer) {
    this.writer = writer;
  }

  /** Returns the report as text; its last line is terminated. */
  public String write(ValidationReport report, Style style) {
    return writer.apply(report, style);
  }
}
