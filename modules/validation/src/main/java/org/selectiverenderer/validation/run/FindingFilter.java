package org.selectiverenderer.validation.run;

import java.util.Map;
import java.util.function.BiPredicate;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.ValidationSettings;

/** Filters out findings that the settings ignore or that comments in files suppress. */
record FindingFilter(ValidationSettings settings, Map<String, Suppressions> suppressions)
    implements BiPredicate<Rule, SourceLocation> {
  @Override
  public boolean test(Rule rule, SourceLocation place) {
    if (settings.ignores(rule.id())) {
      return false;
    }
    Suppressions ofFile = suppressions.get(place.file());
    return ofFile == null || !ofFile.cover(rule, place);
  }
}
