package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;

/** Reads the enrichment of a scene once, for all that look at it. */
record EnrichmentCheck(List<EnrichmentPart> parts) implements SceneCheck {
  @Override
  public void check(SceneView view, Findings findings) {
    if (view.part()) {
      return; // Its areas and objects may have their counterparts in other rooms.
    }
    EnrichedScene scene = EnrichedScene.of(view);
    parts.forEach(part -> part.check(scene, findings));
  }
}
