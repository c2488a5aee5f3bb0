package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Declares the rules SR100 to SR199, about the X3D language. */
public final class LanguageRules {
  private LanguageRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    List<Rule> rules =
        Stream.of(
                FieldRules.ALL,
                ContainmentRules.ALL,
                HeadRules.ALL,
                DefUseRules.ALL,
                RouteRules.ALL,
                PrototypeRules.ALL,
                SequenceRules.ALL)
            .flatMap(List::stream)
            .toList();
    return new RuleGroup(
        "X3D",
        rules,
        List.of(
            new UnknownElementCheck(),
            new FieldCheck(),
            new StatementAttributeCheck(),
            new KeySequenceCheck(),
            new FieldRangeCheck(),
            new HeadCheck(),
            new ProfileCheck(),
            new LanguageVersionCheck(),
            new StatementPlacementCheck(),
            new CompositeCheck()),
        List.of());
  }

  /** Runs the checks that need the name scopes of a file. */
  private static final class CompositeCheck implements FileCheck {
    @Override
    public void check(FileContext file, FindingCollector findings) {
      NameScopes scopes = new NameScopes(file);
      List<NameScopeCheck> checks =
          List.of(
              new ContainmentCheck(),
              new DefUseCheck(),
              new RouteCheck(),
              new PrototypeCheck(),
              new PrototypeConnectCheck());
      for (DocumentElement element : file.document().elements()) {
        checks.forEach(check -> check.check(element, scopes, findings));
      }
    }
  }
}
