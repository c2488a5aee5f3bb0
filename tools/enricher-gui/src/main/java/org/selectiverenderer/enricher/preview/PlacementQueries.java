package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.RayCaster;

/**
 * Finds places in the running scene where something can stand. Asked on the event dispatch thread,
 * which gets the answers.
 */
final class PlacementQueries {
  /** The distance before the viewer, in metres. */
  private static final double AHEAD = 2;

  /** The height of the eyes where no floor is below them, in metres. */
  private static final double EYES = 1.6;

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

  /** Answers the floor before the viewer. */
  void ahead(Consumer<Optional<Vector3d>> answer) {
    ask(
        stage ->
            stage
                .scene()
                .map(
                    scene -> {
                      Vector3dc eye = scene.pose().position();
                      Vector3d way = scene.pose().orientation().transform(new Vector3d(0, 0, -1));
                      way.y = 0;
                      double length = way.length();
                      Vector3d over = new Vector3d(eye);
                      if (length > 1e-6) {
                        way.div(length);
                        double free =
                            scene.hit(eye, way).map(RayCaster.Hit::distance).orElse(2 * AHEAD);
                        over.fma(Math.min(AHEAD, free / 2), way);
                      }
                      return below(scene, over, over.y - EYES);
                    }),
        answer);
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
