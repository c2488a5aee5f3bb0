package org.selectiverenderer.render.preview;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.ShapeInstance;

/**
 * Options of an author's preview: what it shows beyond what a viewer of the scene sees.
 *
 * @param boxes boxes drawn over the scene
 * @param masked shapes whose pixels get alpha 255 in the picture, hidden pixels included; all
 *     others get 0
 * @param wireframe whether only the edges of the triangles are drawn
 * @param backdrop the background to use instead of the bound Background
 */
public record PreviewOptions(
    List<BoxOverlay> boxes,
    Set<ShapeInstance> masked,
    boolean wireframe,
    Optional<Background> backdrop) {
  /** A preview without boxes, mask or wireframe. */
  public static final PreviewOptions NONE =
      new PreviewOptions(List.of(), Set.of(), false, Optional.empty());
}
