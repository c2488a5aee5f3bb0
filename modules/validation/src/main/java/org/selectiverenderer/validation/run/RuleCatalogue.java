package org.selectiverenderer.validation.run;

import java.util.ArrayList;
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

/** The catalogue of all rules, group by group. */
public record RuleCatalogue(List<RuleGroup> groups) {
  /** Makes defensive copies, so that the record is immutable. */
  public RuleCatalogue {
    groups = List.copyOf(groups);
  }

  /** Returns the program's own rules. */
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

  /** Returns a catalogue with another group at the end. */
  public RuleCatalogue with(RuleGroup group) {
    List<RuleGroup> all = new ArrayList<>(groups);
    all.add(group);
    return new RuleCatalogue(all);
  }

  /** Returns all rules in the order of their ids. */
  public List<Rule> rules() {
    return groups.stream().flatMap(group -> group.rules().stream()).toList();
  }

  /** Returns the rule with an id, ignoring case. */
  public Optional<Rule> find(String id) {
    return rules().stream().filter(rule -> rule.id().equalsIgnoreCase(id)).findFirst();
  }

  /**
   * Resolves an id or a prefix of ids that a user typed, such as {@code sr2}, to its canonical
   * spelling; empty if no rule matches.
   */
  public Optional<String> resolve(String id) {
    String wanted = id.strip().toUpperCase(Locale.ROOT);
    return wanted.length() > 2 && rules().stream().anyMatch(rule -> rule.id().startsWith(wanted))
        ? Optional.of(wanted)
        : Optional.empty();
  }
}
