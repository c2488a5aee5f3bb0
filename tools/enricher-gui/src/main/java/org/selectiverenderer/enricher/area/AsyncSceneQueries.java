package org.selectiverenderer.enricher.area;

import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Asynchronous queries of the running scene in the preview. Answers come later, on the event
 * dispatch thread; none comes when there is no running scene any more.
 */
public interface AsyncSceneQueries {
  /**
   * Answers the bounds of an area around an element: its own bounds with room to stand beside it,
   * from the floor up; empty if nothing of it is visible.
   */
  void around(DocumentElement element, Consumer<Optional<BoundingBox>> answer);

  /** Answers the bounds of the room in which the viewer is: up to its walls, floor and ceiling. */
  void room(Consumer<Optional<BoundingBox>> answer);

  /**
   * Answers the box over a rectangle of the plan: from the floor to the ceiling there.
   *
   * @param footprint the rectangle; its Y is the height of the cut
   */
  void raised(BoundingBox footprint, Consumer<Optional<BoundingBox>> answer);

  /**
   * Answers an image of the scene from above, cut at a height.
   *
   * @param cut height in metres; empty for the eye height at the start viewpoint
   */
  void plan(Optional<Double> cut, Consumer<Optional<FloorPlanImage>> answer);
}
