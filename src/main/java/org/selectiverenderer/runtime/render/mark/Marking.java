package org.selectiverenderer.runtime.render.mark;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/**
 * How an author looks at a scene, beyond what a viewer of it sees.
 *
 * @param boxes drawn over the scene
 * @param masked shapes whose pixels have the alpha 255 in the picture, all others 0; those behind
 *     something count as well
 * @param wireframe whether only the edges of the triangles are drawn
 * @param backdrop instead of the bound Background
 */
public record Marking(
    List<BoxMark> boxes,
    Set<ShapeInstance> masked,
    boolean wireframe,
    Optional<Backdrop> backdrop) {
  /** Nothing beyond. */
  public static final Marking NONE = new Marking(List.of(), Set.of(), false, Optional.empty());
}
