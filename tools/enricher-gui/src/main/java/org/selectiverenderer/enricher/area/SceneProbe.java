package org.selectiverenderer.enricher.area;

import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * What is asked of the running scene. Answers come later, on the event dispatch thread; none comes
 * when there is no running scene any more.
 */
public interface SceneProbe {
  /**
   * Where an area around an element would be: its bounds with room to stand beside it, from the
   * floor up; empty if nothing of it is shown.
   */
  void around(DocumentElement element, Consumer<Optional<Bounds>> answer);

  /** The room that the author looks from: up to its walls, floor and ceiling. */
  void room(Consumer<Optional<Bounds>> answer);

  /**
   * A rectangle of the plan with its height: from the floor to the ceiling there.
   *
   * @param footprint whose Y is the height of the cut
   */
  void raised(Bounds footprint, Consumer<Optional<Bounds>> answer);

  /**
   * The scene from above, cut at a height.
   *
   * @param cut height; empty for that of the eye at the start
   */
  void plan(Optional<Double> cut, Consumer<Optional<PlanPicture>> answer);
}
