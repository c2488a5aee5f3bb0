package org.selectiverenderer.validation.enrichment;

import org.selectiverenderer.schema.NodeMetadata;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.ParsedNode;

/** The metadata of each ProximitySensor by itself. */
final class SensorCheck implements EnrichmentPart {
  @Override
  public void check(EnrichedScene scene, Findings findings) {
    for (ParsedNode node : scene.nodes()) {
      if (EnrichedScene.isArea(node)) {
        check(scene, node, findings);
      }
    }
  }

  private static void check(EnrichedScene scene, ParsedNode sensor, Findings findings) {
    boolean[] emptyExit = {false};
    SchemaReader reader =
        new SchemaReader(
            problem -> {
              NodeMetadata at = (NodeMetadata) problem.metadata();
              emptyExit[0] |= SchemaField.of(at.name()).equals(SchemaField.of("exitTimeSchema"));
              if (problem.kind() == SchemaProblem.Kind.NO_SCHEMA) {
                findings.add(SensorRules.NAMES_NOTHING, at.node(), at.name().strip());
              } else {
                findings.add(
                    SchemaRules.MISPLACED, at.node(), at.name().strip(), Misplacement.IN_AREA);
              }
            });
    SensorSchemas schemas = NodeMetadata.of(sensor).flatMap(reader::sensor).orElse(null);
    if (schemas == null) {
      if (!scene.heard(sensor)) {
        findings.add(
            scene.model().isPresent() ? SensorRules.WITHOUT_SCHEMAS : SensorRules.NOT_ENRICHED,
            sensor);
      }
    } else if (!schemas.enter().isEmpty() && schemas.exit().isEmpty() && !emptyExit[0]) {
      findings.add(SensorRules.WITHOUT_EXIT, sensor);
    }
  }
}
