package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.area.SurfacePoint;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Answers scene queries from the preview's scene, on the preview's thread. */
final class PreviewSceneQueries implements AsyncSceneQueries {
  private final PreviewThread thread;
  private final SourceAnchorResolver anchors;

  /**
   * @param anchors maps elements of the document to nodes of the scene and back
   */
  PreviewSceneQueries(PreviewThread thread, SourceAnchorResolver anchors) {
    this.thread = thread;
    this.anchors = anchors;
  }

  private <T> void ask(Function<PreviewScene, Optional<T>> question, Consumer<Optional<T>> answer) {
    if (!thread.alive()) {
      SwingUtilities.invokeLater(() -> answer.accept(Optional.empty()));
      return;
    }
    thread.ask(
        stage -> {
          Optional<T> found = stage.scene().flatMap(question);
          SwingUtilities.invokeLater(() -> answer.accept(found));
        });
  }

  @Override
  public void around(List<DocumentElement> elements, Consumer<Optional<BoundingBox>> answer) {
    List<List<SourceAnchor>> of = elements.stream().map(anchors::of).toList();
    ask(
        scene ->
            of.stream()
                .flatMap(each -> scene.nodes().find(each).flatMap(scene::bounds).stream())
                .reduce(BoundingBox::union)
                .map(new RoomEstimator(scene)::around),
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
  public void plan(
      OptionalDouble cut, List<DocumentElement> hidden, Consumer<Optional<FloorPlanImage>> answer) {
    List<SelectedNode> out = anchors.nodes(hidden);
    ask(scene -> FloorPlanRenderer.of(scene, cut, new ObjectQueries(scene).shapes(out)), answer);
  }

  @Override
  public void boxes(List<DocumentElement> nodes, Consumer<List<ObjectBox>> answer) {
    List<SelectedNode> of = anchors.nodes(nodes);
    ask(
        scene -> {
          ObjectQueries queries = new ObjectQueries(scene);
          return Optional.of(of.stream().flatMap(each -> queries.box(each).stream()).toList());
        },
        found -> answer.accept(found.orElse(List.of())));
  }

  /** A picked surface in the text of a revision. */
  private record Picked(
      Vector3dc point,
      Optional<PreviewController.Picked> innermost,
      Optional<PreviewController.Picked> meant) {}

  @Override
  public void below(
      Vector3dc from, List<DocumentElement> hidden, Consumer<Optional<SurfacePoint>> answer) {
    List<SelectedNode> out = anchors.nodes(hidden);
    this.<Picked>ask(
        scene -> {
          ObjectQueries queries = new ObjectQueries(scene);
          return queries
              .hit(from, new Vector3d(0, -1, 0), queries.shapes(out))
              .map(
                  hit ->
                      new Picked(
                          hit.point(),
                          scene.nodes().meant(hit.shape(), true).map(node -> picked(scene, node)),
                          scene
                              .nodes()
                              .meant(hit.shape(), false)
                              .map(node -> picked(scene, node))));
        },
        found ->
            answer.accept(
                found.map(
                    hit ->
                        new SurfacePoint(
                            hit.point(),
                            hit.innermost().flatMap(anchors::element),
                            hit.meant().flatMap(anchors::element)))));
  }

  private static PreviewController.Picked picked(PreviewScene scene, Node node) {
    return new PreviewController.Picked(scene.nodes().anchor(node), scene.revision());
  }

  @Override
  public void within(
      BoundingBox footprint, List<DocumentElement> hidden, Consumer<List<DocumentElement>> answer) {
    List<SelectedNode> out = anchors.nodes(hidden);
    this.<List<PreviewController.Picked>>ask(
        scene -> {
          ObjectQueries queries = new ObjectQueries(scene);
          return Optional.of(
              queries.within(footprint, queries.shapes(out)).stream()
                  .map(node -> picked(scene, node))
                  .toList());
        },
        found ->
            answer.accept(
                found.orElse(List.of()).stream()
                    .flatMap(each -> anchors.element(each).stream())
                    .toList()));
  }

  @Override
  public void support(List<ObjectBox> boxes, Consumer<List<OptionalDouble>> answer) {
    List<SelectedNode> all = anchors.nodes(boxes.stream().map(ObjectBox::element).toList());
    ask(
        scene -> {
          ObjectQueries queries = new ObjectQueries(scene);
          return Optional.of(
              boxes.stream()
                  .map(box -> queries.support(box.bounds(), queries.shapes(all)))
                  .toList());
        },
        found -> answer.accept(found.orElse(List.of())));
  }
}
