package org.selectiverenderer.validation;

import java.util.Collection;
import java.util.List;
import java.util.Map;

/** Leaves out what the user does not want to hear of, and weighs the rest as configured. */
record FindingFilter(ValidationSettings settings, Map<String, Suppressions> suppressions) {
  List<Finding> apply(Collection<Finding> findings) {
    return findings.stream()
        .filter(finding -> !settings.ignores(finding.rule().id()))
        .filter(finding -> !suppressed(finding))
        .map(finding -> finding.with(settings.severity(finding.rule())))
        .toList();
  }

  private boolean suppressed(Finding finding) {
    Suppressions ofFile = suppressions.get(finding.location().file());
    return ofFile != null && ofFile.cover(finding);
  }
}
