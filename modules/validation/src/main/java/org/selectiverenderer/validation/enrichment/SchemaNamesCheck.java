package org.selectiverenderer.validation.enrichment;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.SchemaUsage;
import org.selectiverenderer.schema.SchemaUsage.Unmatched;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Finds schemas that only areas or only objects name; the controller reports the same ones when it
 * starts.
 */
final class SchemaNamesCheck implements EnrichedSceneCheck {
  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    SchemaUsage<ParsedNode> use = new SchemaUsage<>();
    scene.areas().forEach(use::area);
    scene
        .objects()
        .forEach(
            (object, schemas) ->
                use.object(object, byChoice(schemas), object.integer("whichChoice")));
    scene
        .qualities()
        .forEach(
            (object, qualities) ->
                qualities.stream()
                    .map(FieldQuality::schemas)
                    .forEach(
                        levels -> use.object(object, levels.byChoice(), levels.mostDetailed())));
    Set<String> activated = use.activated();
    Set<String> explained = new HashSet<>();
    for (Unmatched<ParsedNode> found : use.unmatched()) {
      String schema = found.schema();
      if (explained.contains(schema)) {
        continue; // It is the suggested spelling of another name, which is reported already.
      }
      if (found.meant().isPresent()) {
        String meant = found.meant().get();
        findings.add(SchemaRules.ALMOST_THE_SAME, found.node(), schema, meant);
        explained.add(meant);
      } else if (activated.contains(schema)) {
        findings.add(SchemaRules.OF_NO_SWITCH, found.node(), schema);
      } else {
        findings.add(SchemaRules.OF_NO_AREA, found.node(), schema);
      }
    }
  }

  private static List<List<String>> byChoice(SwitchSchemas schemas) {
    int count = schemas.choices().stream().mapToInt(VersionMetadata::index).max().orElse(-1) + 1;
    List<List<String>> lists = new ArrayList<>(Collections.nCopies(count, List.of()));
    schemas.choices().forEach(choice -> lists.set(choice.index(), List.copyOf(choice.schemas())));
    return lists;
  }
}
