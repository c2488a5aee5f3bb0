package org.selectiverenderer.validation.enrichment;

import org.selectiverenderer.validation.Findings;

/** Looks at one side of a scene's enrichment. Without state. */
interface EnrichmentPart {
  void check(EnrichedScene scene, Findings findings);
}
