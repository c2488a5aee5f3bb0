package org.selectiverenderer.validation.enrichment;

import org.selectiverenderer.validation.FindingCollector;

/** A check of one aspect of a scene's enrichment. Implementations are stateless. */
interface EnrichedSceneCheck {
  void check(EnrichedScene scene, FindingCollector findings);
}
