package org.selectiverenderer.validation;

import java.util.Comparator;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * A finding: a violation of a rule at a location in a file (SARIF: result).
 *
 * @param severity the rule's severity, unless the settings change it
 * @param location the file as reports name it; line 0 for the file as a whole
 * @param node type and DEF name of the node concerned; empty for none
 * @param message one sentence
 */
public record Finding(
    Rule rule, Severity severity, SourceLocation location, String node, String message) {
  /** The order of findings in reports: by file, line, column, rule, then node and message. */
  public static final Comparator<Finding> ORDER =
      Comparator.comparing((Finding finding) -> finding.location().file())
          .thenComparingInt(finding -> finding.location().line())
          .thenComparingInt(finding -> finding.location().column())
          .thenComparing(finding -> finding.rule().id())
          .thenComparing(Finding::message)
          .thenComparing(Finding::node)
          .thenComparing(Finding::severity);

  /** Returns the same finding with another severity. */
  public Finding with(Severity other) {
    return new Finding(rule, other, location, node, message);
  }
}
