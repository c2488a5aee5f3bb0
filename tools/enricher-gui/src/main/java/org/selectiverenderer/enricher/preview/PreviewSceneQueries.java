package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Answers scene queries from the preview's scene, on the preview's thread. */
final class PreviewSceneQueries implements AsyncSceneQueries {
  private final PreviewThread thread;
  private final Function<DocumentElement, List<SourceAnchor>> anchors;

  /**
   * @param anchors returns the anchors of an element and of those around it, the nearest first
   */
  PreviewSceneQueries(PreviewThread thread, Function<DocumentElement, List<SourceAnchor>> anchors) {
    this.thread = thread;
    this.anchors = anchors;
  }

  private <T> void ask(Function<PreviewScene, Optional<T>> question, Consumer<Optional<T>> answer) {
    if (!thread.alive()) {
      SwingUtilities.invokeLater(() -> answer.accept(Optional.empty()));
      return;
    }
    thread.tell(
        stage -> {
          Optional<T> found = stage.scene().flatMap(question);
          SwingUtilities.invokeLater(() -> answer.accept(found));
        });
  }

  @Override
  public void around(DocumentElement element, Consumer<Optional<BoundingBox>> answer) {
    List<SourceAnchor> of = anchors.apply(element);
    ask(
        scene ->
            scene.nodes().find(of).flatMap(scene::bounds).map(new RoomEstimator(scene)::around),
        answer);
  }

  @Override
  public void room(Consumer<Optional<BoundingBox>> answer) {
    ask(scene -> Optional.of(new RoomEstimator(scene).room(scene.pose().position())), answer);
  }

  @Override
  public void raised(BoundingBox footprint, Consumer<Optional<BoundingBox>> answer) {
    ask(scene -> Optional.of(new RoomEstimator(scene).raised(footprint)), answer);
  }

  @Override
  public void plan(Optional<Double> cut, Consumer<Optional<FloorPlanImage>> answer) {
    ask(
        scene ->
            FloorPlanRenderer.of(
                scene.world().instances().shapes(), cut.orElseGet(scene::startHeight)),
        answer);
  }
}
