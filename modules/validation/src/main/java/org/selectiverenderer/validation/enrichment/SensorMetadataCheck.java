package org.selectiverenderer.validation.enrichment;

import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks the metadata of each ProximitySensor by itself. */
final class SensorMetadataCheck implements EnrichedSceneCheck {
  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    for (ParsedNode node : scene.nodes()) {
      if (EnrichedScene.isArea(node)) {
        check(scene, node, findings);
      }
    }
  }

  private static void check(EnrichedScene scene, ParsedNode sensor, FindingCollector findings) {
    FileOutline file = scene.file(sensor);
    boolean[] emptyExit = {false};
    SchemaReader reader =
        new SchemaReader(
            problem -> {
              NodeViewMetadata at = (NodeViewMetadata) problem.metadata();
              emptyExit[0] |= SchemaField.of(at.name()).equals(SchemaField.of("exitTimeSchema"));
              if (problem.kind() == SchemaProblem.Kind.NO_SCHEMA) {
                findings.addAt(
                    SensorRules.NAMES_NOTHING, file, at.node(), "value", at.name().strip());
              } else {
                findings.addAt(
                    SchemaRules.MISPLACED,
                    file,
                    at.node(),
                    "name",
                    at.name().strip(),
                    MisplacedMetadataMessages.IN_AREA);
              }
            });
    SensorSchemas schemas = NodeViewMetadata.of(sensor).flatMap(reader::sensor).orElse(null);
    if (schemas == null) {
      if (!scene.heard(sensor) && !slipOfSize(scene, sensor)) {
        findings.add(
            scene.model().isPresent() ? SensorRules.WITHOUT_SCHEMAS : SensorRules.NOT_ENRICHED,
            sensor);
      }
    } else if (!schemas.enter().isEmpty() && schemas.exit().isEmpty() && !emptyExit[0]) {
      findings.add(SensorRules.WITHOUT_EXIT, sensor);
    }
  }

  /** Returns whether all sides of the box are longer than 0. */
  static boolean hasVolume(ParsedNode sensor) {
    float[] size = sensor.floats("size");
    return size[0] > 0 && size[1] > 0 && size[2] > 0;
  }

  /** Returns whether an invalid size is given, which another rule reports. */
  private static boolean slipOfSize(EnrichedScene scene, ParsedNode sensor) {
    return sensor.given(sensor.type().indexOf("size"))
        && !hasVolume(sensor)
        && !scene.driven(sensor, "size");
  }
}
