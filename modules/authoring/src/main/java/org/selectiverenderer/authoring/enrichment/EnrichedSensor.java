package org.selectiverenderer.authoring.enrichment;

import java.util.List;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A ProximitySensor of a document with its schema metadata: an area.
 *
 * @param name its DEF, or {@code ProximitySensor#3} for the third one if it has none
 * @param schemas its schemas; none where it has no schema metadata
 * @param enriched whether it has schema metadata
 * @param findings the findings about its metadata
 */
public record EnrichedSensor(
    DocumentElement element,
    String name,
    SensorSchemas schemas,
    boolean enriched,
    List<ElementFinding> findings) {
  public EnrichedSensor {
    findings = List.copyOf(findings);
  }
}
