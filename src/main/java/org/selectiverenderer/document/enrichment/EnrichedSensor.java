package org.selectiverenderer.document.enrichment;

import java.util.List;
import org.selectiverenderer.document.ElementFinding;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A ProximitySensor of a document: an area.
 *
 * @param name its DEF, or {@code ProximitySensor#3} for the third one if it has none
 * @param schemas none where the metadata has no words of the vocabulary
 * @param enriched whether it has
 * @param findings what is wrong with its metadata
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
