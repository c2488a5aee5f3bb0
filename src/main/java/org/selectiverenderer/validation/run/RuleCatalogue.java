package org.selectiverenderer.validation.run;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;
import org.selectiverenderer.validation.budget.BudgetRules;
import org.selectiverenderer.validation.enrichment.EnrichmentRules;
import org.selectiverenderer.validation.files.FileRules;
import org.selectiverenderer.validation.geometry.GeometryRules;
import org.selectiverenderer.validation.language.LanguageRules;
import org.selectiverenderer.validation.script.ScriptRules;
import org.selectiverenderer.validation.xml.XmlRules;

/** All that the validator can say, group by group. */
public record RuleCatalogue(List<RuleGroup> groups) {
  /** Keeps copies, so that it stays as it is. */
  public RuleCatalogue {
    groups = List.copyOf(groups);
  }

  /** The program's own rules. */
  public static RuleCatalogue standard() {
    return new RuleCatalogue(
        List.of(
            XmlRules.group(),
            LanguageRules.group(),
            GeometryRules.group(),
            FileRules.group(),
            EnrichmentRules.group(),
            BudgetRules.group(),
            ScriptRules.group()));
  }

  /** All rules in the order of their ids. */
  public List<Rule> rules() {
    return groups.stream().flatMap(group -> group.rules().stream()).toList();
  }

  /** The rule of an id in any case. */
  public Optional<Rule> find(String id) {
    return rules().stream().filter(rule -> rule.id().equalsIgnoreCase(id)).findFirst();
  }

  /**
   * What a user means by an id or by the beginning of ids, such as {@code sr2}: as rules are
   * compared with it; empty if it fits none.
   */
  public Optional<String> resolve(String id) {
    String wanted = id.strip().toUpperCase(Locale.ROOT);
    return wanted.length() > 2 && rules().stream().anyMatch(rule -> rule.id().startsWith(wanted))
        ? Optional.of(wanted)
        : Optional.empty();
  }
}
