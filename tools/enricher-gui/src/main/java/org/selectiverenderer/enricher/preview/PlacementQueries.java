package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.joml.Intersectiond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Finds places in the running scene where something can stand. Asked on the event dispatch thread,
 * which gets the answers.
 */
final class PlacementQueries {
  /** The distance before the viewer, in metres. */
  private static final double AHEAD = 2;

  /** The height of the eyes where no floor is below them, in metres. */
  private static final double EYES = 1.6;

  /** The room above something low in which the eyes of a viewer who stands on it are. */
  private static final double TALL = 2.5;

  /** The least Y of the normal of a surface on which something can stand. */
  private static final double LEVEL = 0.7;

  private static final double NEAR = 0.01;

  private final PreviewThread thread;

  PlacementQueries(PreviewThread thread) {
    this.thread = thread;
  }

  private void ask(
      Function<PreviewController, Optional<Vector3d>> question,
      Consumer<Optional<Vector3d>> answer) {
    if (!thread.alive()) {
      SwingUtilities.invokeLater(() -> answer.accept(Optional.empty()));
      return;
    }
    thread.tell(
        stage -> {
          Optional<Vector3d> found = question.apply(stage);
          SwingUtilities.invokeLater(() -> answer.accept(found));
        });
  }

  /** Answers what is under a pixel; empty where nothing is. */
  void under(int x, int y, Consumer<Optional<Vector3d>> answer) {
    ask(stage -> stage.hit(x, y), answer);
  }

  /**
   * Answers the floor before a viewer who stands in the scene, else the surface in the middle of
   * what the picture shows of the scene.
   */
  void ahead(Consumer<Optional<Vector3d>> answer) {
    ask(stage -> stage.scene().map(PlacementQueries::ahead), answer);
  }

  private static Vector3d ahead(PreviewScene scene) {
    Vector3dc eye = scene.pose().position();
    Optional<BoundingBox> shown = scene.bounds().filter(box -> !box.isEmpty());
    if (shown.isPresent() && !around(shown.get()).contains(eye)) {
      return inPicture(scene, shown.get());
    }
    Vector3d way = scene.pose().orientation().transform(new Vector3d(0, 0, -1));
    way.y = 0;
    double length = way.length();
    Vector3d over = new Vector3d(eye);
    if (length > 1e-6) {
      way.div(length);
      double free = scene.hit(eye, way).map(RayCaster.Hit::distance).orElse(2 * AHEAD);
      over.fma(Math.min(AHEAD, free / 2), way);
    }
    shown.ifPresent(box -> keepOver(box, over));
    // Where nothing is below, the eyes may be at any height: that of the scene's lowest point tells
    // where its ground is, and an empty scene's is at 0.
    return below(scene, over, shown.map(BoundingBox::minY).orElse(0.0));
  }

  /** Returns where a viewer's eyes may be who stands on something in a box. */
  private static BoundingBox around(BoundingBox box) {
    return box.union(
        BoundingBox.of(box.min(), box.max().add(0, box.height() < EYES ? TALL : 0, 0)));
  }

  private static void keepOver(BoundingBox box, Vector3d point) {
    point.x = Math.max(box.minX(), Math.min(box.maxX(), point.x));
    point.z = Math.max(box.minZ(), Math.min(box.maxZ(), point.z));
  }

  /**
   * Returns the ground that is in the middle of the picture; where something steep is there, what
   * is below the middle of the line of sight's part in the box, as in the room behind a wall.
   */
  private static Vector3d inPicture(PreviewScene scene, BoundingBox shown) {
    Vector3dc eye = scene.pose().position();
    Vector3d sight = scene.pose().orientation().transform(new Vector3d(0, 0, -1));
    Optional<RayCaster.Hit> hit =
        scene
            .hit(eye, sight)
            .filter(
                found -> found.normal().y() > LEVEL && shown.grown(NEAR).contains(found.point()));
    if (hit.isPresent()) {
      return new Vector3d(hit.get().point());
    }
    Vector3d middle = shown.min().add(shown.max()).mul(0.5);
    Vector2d part = new Vector2d();
    if (Intersectiond.intersectRayAab(eye, sight, shown.min(), shown.max(), part)) {
      middle.set(eye).fma((part.x + part.y) / 2, sight);
    }
    return below(scene, middle, shown.minY());
  }

  /** Answers the floor or the surface below a point; the point's own height where nothing is. */
  void below(Vector3dc point, Consumer<Optional<Vector3d>> answer) {
    ask(stage -> stage.scene().map(scene -> below(scene, point, point.y())), answer);
  }

  private static Vector3d below(PreviewScene scene, Vector3dc from, double otherwise) {
    return scene
        .hit(from, new Vector3d(0, -1, 0))
        .map(hit -> new Vector3d(hit.point()))
        .orElseGet(() -> new Vector3d(from.x(), otherwise, from.z()));
  }
}
