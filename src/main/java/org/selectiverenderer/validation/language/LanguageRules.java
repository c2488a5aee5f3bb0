package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR1xx: the X3D language. */
public final class LanguageRules {
  private LanguageRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    List<Rule> rules =
        Stream.of(
                FieldRules.ALL,
                ContainmentRules.ALL,
                HeadRules.ALL,
                NameRules.ALL,
                RouteRules.ALL,
                PrototypeRules.ALL,
                SequenceRules.ALL)
            .flatMap(List::stream)
            .toList();
    return new RuleGroup(
        "X3D",
        rules,
        List.of(
            new ElementCheck(),
            new FieldCheck(),
            new StatementCheck(),
            new SequenceCheck(),
            new RangeCheck(),
            new HeadCheck(),
            new ProfileCheck(),
            new LanguageVersionCheck(),
            new PlacementCheck(),
            new ScopeChecks()),
        List.of());
  }
}
