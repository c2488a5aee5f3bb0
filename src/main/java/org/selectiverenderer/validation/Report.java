package org.selectiverenderer.validation;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.base.problem.Problem.Severity;

/**
 * What a run found.
 *
 * @param files that were checked, Inlines included, by name
 * @param findings in the order of {@link Finding#ORDER}
 * @param dropped how many more there are, beyond {@link Findings#LIMIT} of a rule and a file
 */
public record Report(List<SourceFile> files, List<Finding> findings, int dropped) {
  /** Keeps copies, so that it stays as it is. */
  public Report {
    files = List.copyOf(files);
    findings = List.copyOf(findings);
  }

  /** Sorts. */
  public static Report of(Collection<SourceFile> files, Collection<Finding> findings, int dropped) {
    return new Report(
        files.stream().sorted(Comparator.comparing(SourceFile::name)).toList(),
        findings.stream().sorted(Finding.ORDER).toList(),
        dropped);
  }

  /** How many findings are that severe. */
  public int count(Severity severity) {
    return (int) findings.stream().filter(finding -> finding.severity() == severity).count();
  }

  /** Whether anything found is as severe as that, or more so. */
  public boolean has(Severity least) {
    return findings.stream().anyMatch(finding -> finding.severity().compareTo(least) <= 0);
  }
}
