package org.selectiverenderer.validation;

import java.util.Comparator;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem.Severity;

/**
 * Something found in a file.
 *
 * @param severity the rule's, or what a configuration makes of it
 * @param location the file as reports name it; line 0 for the file as a whole
 * @param node type and DEF name of the node that it is about; empty if about none
 * @param message one sentence
 */
public record Finding(
    Rule rule, Severity severity, Location location, String node, String message) {
  /** The order of reports: file, line, column, rule, and what tells two such findings apart. */
  public static final Comparator<Finding> ORDER =
      Comparator.comparing((Finding finding) -> finding.location().file())
          .thenComparingInt(finding -> finding.location().line())
          .thenComparingInt(finding -> finding.location().column())
          .thenComparing(finding -> finding.rule().id())
          .thenComparing(Finding::message)
          .thenComparing(Finding::node)
          .thenComparing(Finding::severity);

  /** The same finding, taken more or less seriously. */
  public Finding with(Severity other) {
    return new Finding(rule, other, location, node, message);
  }
}
