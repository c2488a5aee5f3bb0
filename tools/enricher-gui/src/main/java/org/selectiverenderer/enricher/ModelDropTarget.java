package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Point;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.enricher.plan.PlanPanel;
import org.selectiverenderer.enricher.preview.PreviewPanel;

/**
 * Finds the place in the scene onto which a model is dropped: what the mouse is over in the preview
 * or the plan, else the floor before the viewer. For the event dispatch thread.
 *
 * @param tree the tree of the scene, which models may be dropped on too
 */
record ModelDropTarget(PreviewPanel preview, PlanPanel plan, Component tree) {
  /** Returns whether a model that is dropped at a point becomes part of the scene. */
  boolean takes(Component over, Point at) {
    Component deepest = deepest(over, at);
    return within(deepest, preview) || within(deepest, plan) || within(deepest, tree);
  }

  private static Component deepest(Component over, Point at) {
    Component found = SwingUtilities.getDeepestComponentAt(over, at.x, at.y);
    return found == null ? over : found;
  }

  private static boolean within(Component one, Component other) {
    return one == other || SwingUtilities.isDescendingFrom(one, other);
  }

  /** Answers the place in scene coordinates under a point. */
  void place(Component over, Point at, Consumer<Vector3dc> answer) {
    Component deepest = deepest(over, at);
    if (within(deepest, preview)) {
      preview.place(over, at, found -> found.ifPresentOrElse(answer, () -> ahead(answer)));
    } else if (within(deepest, plan)) {
      Optional<Vector3d> ground = plan.place(over, at);
      ground.ifPresentOrElse(point -> preview.onFloor(point, answer::accept), () -> ahead(answer));
    } else {
      ahead(answer);
    }
  }

  /** Answers the place on the floor before the viewer; the origin while there is no picture. */
  void ahead(Consumer<Vector3dc> answer) {
    preview.placeAhead(found -> answer.accept(found.orElseGet(Vector3d::new)));
  }
}
