package org.selectiverenderer.enricher.area;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Asynchronous queries of the running scene in the preview. Answers come later, on the event
 * dispatch thread; none comes when there is no running scene any more.
 */
public interface AsyncSceneQueries {
  /**
   * Answers the bounds of an area around all of some elements: their bounds with room to stand
   * beside them, from the floor up; empty if nothing of them is visible.
   */
  void around(List<DocumentElement> elements, Consumer<Optional<BoundingBox>> answer);

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
   * @param cut height in metres; empty for one between floor and ceiling, at the eye height of the
   *     start viewpoint if that is
   * @param hidden nodes that are left out
   */
  void plan(
      OptionalDouble cut, List<DocumentElement> hidden, Consumer<Optional<FloorPlanImage>> answer);

  /** Answers the boxes of those nodes that show something, in their order. */
  void boxes(List<DocumentElement> nodes, Consumer<List<ObjectBox>> answer);

  /**
   * Answers the first surface below a point of the plan; empty if there is none.
   *
   * @param from the point, in the height of the cut
   * @param hidden nodes whose surfaces are passed through
   */
  void below(Vector3dc from, List<DocumentElement> hidden, Consumer<Optional<SurfacePoint>> answer);

  /**
   * Answers the nodes that clicks on the shapes within a rectangle of the plan select: those whose
   * visible shapes all lie in it.
   *
   * @param footprint the rectangle; its Y is the height of the cut, above which nothing counts
   */
  void within(
      BoundingBox footprint, List<DocumentElement> hidden, Consumer<List<DocumentElement>> answer);

  /**
   * Answers the height of what is below each of some boxes: the lowest surface that rays from their
   * tops hit, other than their own nodes.
   */
  void support(List<ObjectBox> boxes, Consumer<List<OptionalDouble>> answer);
}
