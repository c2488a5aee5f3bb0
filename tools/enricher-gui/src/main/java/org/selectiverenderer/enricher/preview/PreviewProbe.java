package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.selectiverenderer.enricher.area.PlanPicture;
import org.selectiverenderer.enricher.area.SceneProbe;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Answers scene queries from the preview's scene, on the preview's thread. */
final class PreviewProbe implements SceneProbe {
  private final PreviewThread thread;
  private final Function<DocumentElement, List<Anchor>> anchors;

  /**
   * @param anchors returns the anchors of an element and of those around it, the nearest first
   */
  PreviewProbe(PreviewThread thread, Function<DocumentElement, List<Anchor>> anchors) {
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
  public void around(DocumentElement element, Consumer<Optional<Bounds>> answer) {
    List<Anchor> of = anchors.apply(element);
    ask(
        scene -> scene.nodes().find(of).flatMap(scene::bounds).map(new Rooms(scene)::around),
        answer);
  }

  @Override
  public void room(Consumer<Optional<Bounds>> answer) {
    ask(scene -> Optional.of(new Rooms(scene).room(scene.pose().position())), answer);
  }

  @Override
  public void raised(Bounds footprint, Consumer<Optional<Bounds>> answer) {
    ask(scene -> Optional.of(new Rooms(scene).raised(footprint)), answer);
  }

  @Override
  public void plan(Optional<Double> cut, Consumer<Optional<PlanPicture>> answer) {
    ask(
        scene ->
            PlanMaker.of(scene.world().instances().shapes(), cut.orElseGet(scene::startHeight)),
        answer);
  }
}
