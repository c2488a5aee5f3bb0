package org.selectiverenderer.validation.enrichment;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR4xx: enrichment with memory schemata. */
public final class EnrichmentRules {
  private EnrichmentRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Enrichment",
        Stream.of(SensorRules.ALL, SwitchRules.ALL, SchemaRules.ALL, ObjectVersionRules.ALL)
            .flatMap(List::stream)
            .sorted(Comparator.comparing(Rule::id))
            .toList(),
        List.of(),
        List.of(
            new EnrichmentCheck(
                List.of(
                    new SwitchMetadataCheck(),
                    new SensorCheck(),
                    new ReachCheck(),
                    new VocabularyCheck(),
                    new SchemaNamesCheck(),
                    new ObjectVersionCheck(),
                    new StartCheck(),
                    new OverlapCheck(),
                    new ShownCheck()))));
  }
}
