package org.selectiverenderer.validation.enrichment;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;

/** Declares the rules SR400 to SR499, about enrichment with memory schemata. */
public final class EnrichmentRules {
  private EnrichmentRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Enrichment",
        Stream.of(
                SensorRules.ALL,
                SwitchRules.ALL,
                SchemaRules.ALL,
                ObjectVersionRules.ALL,
                FieldQualityRules.ALL)
            .flatMap(List::stream)
            .sorted(Comparator.comparing(Rule::id))
            .toList(),
        List.of(),
        List.of(
            new CompositeCheck(
                List.of(
                    new SwitchMetadataCheck(),
                    new FieldQualityCheck(),
                    new SensorMetadataCheck(),
                    new AreaReachabilityCheck(),
                    new MetadataVocabularyCheck(),
                    new SchemaNamesCheck(),
                    new ObjectVersionCheck(),
                    new InitialChoiceCheck(),
                    new AreaOverlapCheck(),
                    new NeverShownVersionCheck()))));
  }

  /** Runs several checks of a scene's enrichment, which is read once for all of them. */
  private record CompositeCheck(List<EnrichedSceneCheck> parts) implements SceneCheck {
    @Override
    public void check(SceneContext view, FindingCollector findings) {
      if (view.part()) {
        return; // Its areas and objects may refer to those of other files of the whole scene.
      }
      EnrichedScene scene = EnrichedScene.of(view);
      parts.forEach(part -> part.check(scene, findings));
    }
  }
}
