package org.selectiverenderer.validation.enrichment;

import org.selectiverenderer.validation.Findings;

/** A check of one aspect of a scene's enrichment. Implementations are stateless. */
interface EnrichmentPart {
  void check(EnrichedScene scene, Findings findings);
}
