package org.selectiverenderer.validation;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.base.problem.Problem.Severity;

/**
 * The result of a validation run.
 *
 * @param files the checked files, Inlines included, sorted by name
 * @param findings the findings in the order of {@link Finding#ORDER}
 * @param dropped number of further findings beyond {@link FindingCollector#LIMIT} per rule and file
 */
public record ValidationReport(List<SourceFile> files, List<Finding> findings, int dropped) {
  /** Makes defensive copies, so that the record is immutable. */
  public ValidationReport {
    files = List.copyOf(files);
    findings = List.copyOf(findings);
  }

  /** Creates a report with sorted files and findings. */
  public static ValidationReport of(
      Collection<SourceFile> files, Collection<Finding> findings, int dropped) {
    return new ValidationReport(
        files.stream().sorted(Comparator.comparing(SourceFile::name)).toList(),
        findings.stream().sorted(Finding.ORDER).toList(),
        dropped);
  }

  /** Returns the number of findings with a severity. */
  public int count(Severity severity) {
    return (int) findings.stream().filter(finding -> finding.severity() == severity).count();
  }

  /** Returns whether any finding is at least that severe. */
  public boolean has(Severity least) {
    return findings.stream().anyMatch(finding -> finding.severity().compareTo(least) <= 0);
  }
}
