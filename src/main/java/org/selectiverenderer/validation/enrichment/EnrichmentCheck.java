package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;

/** Runs several checks of a scene's enrichment, which is read once for all of them. */
record EnrichmentCheck(List<EnrichmentPart> parts) implements SceneCheck {
  @Override
  public void check(SceneView view, Findings findings) {
    if (view.part()) {
      return; // Its areas and objects may refer to those of other files of the whole scene.
    }
    EnrichedScene scene = EnrichedScene.of(view);
    parts.forEach(part -> part.check(scene, findings));
  }
}
