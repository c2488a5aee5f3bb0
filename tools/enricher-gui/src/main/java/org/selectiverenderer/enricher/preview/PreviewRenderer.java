package org.selectiverenderer.enricher.preview;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.compare.ReferenceImage;
import org.selectiverenderer.render.preview.PreviewImage;
import org.selectiverenderer.render.preview.PreviewOptions;
import org.selectiverenderer.render.preview.ScenePreviewRenderer;

/**
 * Renders the preview's frames: the scene with sensor boxes and the outlined selection, and the
 * reference image in full detail. Confined to the preview's thread.
 */
final class PreviewRenderer {
  private static final int OUTLINE = 0xff8c00;

  private final ScenePreviewRenderer view;
  private CompareMode compare = CompareMode.OFF;
  private boolean sensorsShown = true;
  private boolean wireframe;

  PreviewRenderer(ScenePreviewRenderer view) {
    this.view = view;
  }

  void compare(CompareMode mode) {
    compare = mode;
  }

  /** How the reference image is shown. */
  CompareMode compared() {
    return compare;
  }

  void sensorsShown(boolean show) {
    sensorsShown = show;
  }

  void wireframe(boolean show) {
    wireframe = show;
  }

  /** Returns the labels of the areas for a camera. */
  List<PreviewFrame.Label> labels(PreviewScene of, List<SelectedNode> selection, Camera seenBy) {
    Optional<Node> selected = last(of, selection);
    return sensorsShown ? of.areas().labels(seenBy, selected.orElse(null), of::sees) : List.of();
  }

  /**
   * Renders a frame.
   *
   * @param comparing whether the reference image may be rendered too
   * @param width of one picture, pixels
   * @param samples per pixel; a picture that differs a little from the last one may have more
   */
  PreviewFrame draw(
      PreviewScene shown,
      List<SelectedNode> selection,
      boolean comparing,
      int width,
      int height,
      int samples) {
    Optional<Node> selected = last(shown, selection);
    ObjectQueries queries = new ObjectQueries(shown);
    Set<ShapeInstance> outlined = new HashSet<>(selected.map(shown::shapes).orElse(Set.of()));
    if (selection.size() > 1) {
      outlined.addAll(queries.shapes(selection));
    }
    long begun = System.nanoTime();
    PreviewImage picture =
        view.redraw(
            shown.world(),
            new PreviewOptions(
                sensorsShown ? shown.areas().marks(selected.orElse(null)) : List.of(),
                outlined,
                wireframe,
                Optional.empty()),
            width,
            height,
            samples);
    double milliseconds = (System.nanoTime() - begun) * 1e-6;
    return new PreviewFrame(
        outlined.isEmpty()
            ? ScreenshotConverter.of(picture.pixels())
            : ScreenshotConverter.outlined(picture.pixels(), OUTLINE),
        picture.camera(),
        labels(shown, selection, picture.camera()),
        shown.world().instances().shownPolygons(),
        picture.drawn().triangles(),
        picture.samples(),
        milliseconds,
        shown.enteredAreas(),
        shown.schemas(),
        shown.walking().isPresent(),
        selected.map(Node::toString),
        (int) shown.world().layers().stream().filter(layer -> !layer.active()).count(),
        shown.revision(),
        view.info().renderer() + ", OpenGL " + view.info().version(),
        comparing && compare != CompareMode.OFF
            ? Optional.of(inDetail(shown, width, height, samples))
            : Optional.empty(),
        selection.stream().flatMap(each -> queries.box(each).stream()).toList(),
        VersionOverride.words(shown));
  }

  /** Returns the node selected last, or the nearest one around it that is in the scene. */
  private static Optional<Node> last(PreviewScene of, List<SelectedNode> selection) {
    return selection.isEmpty()
        ? Optional.empty()
        : of.nodes().find(selection.get(selection.size() - 1).anchors());
  }

  private ReferenceImage inDetail(PreviewScene shown, int width, int height, int samples) {
    return shown.inDetail(
        () -> {
          PreviewOptions plain =
              new PreviewOptions(List.of(), Set.of(), wireframe, Optional.empty());
          PreviewImage all = view.draw(shown.world(), plain, width, height, samples);
          return new ReferenceImage(
              compare,
              ScreenshotConverter.of(all.pixels()),
              shown.world().instances().shownPolygons());
        });
  }
}
