package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR4xx: enrichment with memory schemata. */
public final class EnrichmentRules {
  static final Rule FEWER_SETS =
      Rule.warning("SR401", "{fault}")
          .because(
              """
              MetadataSet i describes child i of the Switch; a child without one is never shown by \
              a schema.""")
          .see("thesis 4.3.2, Fig 49");

  private EnrichmentRules() {}

  public static RuleGroup group() {
    return new RuleGroup(
        "Enrichment", List.of(FEWER_SETS), List.of(), List.of(new SwitchMetadataCheck()));
  }
}
