package org.selectiverenderer.enricher.preview;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.selectiverenderer.enricher.session.EnricherSession;

/**
 * Handles clicks in the preview: a left click selects the picked node in the document, a right
 * click shows its context menu.
 */
final class PickHandler implements PreviewInputController.Clicks {
  private final PreviewCanvas view;
  private final PreviewThread thread;
  private final EnricherSession session;
  private final SourceAnchorResolver anchors;
  private final Object origin;
  private BiConsumer<Component, Point> menu = (over, at) -> {};

  /**
   * @param origin the view that is passed as the origin of the selection
   */
  PickHandler(PreviewCanvas view, PreviewThread thread, EnricherSession session, Object origin) {
    this.view = view;
    this.thread = thread;
    this.session = session;
    this.anchors = new SourceAnchorResolver(session.document());
    this.origin = origin;
  }

  /** Sets what shows the context menu of the selected node, over a component at a point. */
  void onMenu(BiConsumer<Component, Point> shown) {
    menu = shown;
  }

  @Override
  public void label(PreviewFrame.Label label) {
    select(
        new PreviewController.Picked(
            label.anchor(), view.frame().map(PreviewFrame::revision).orElse(-1L)));
  }

  @Override
  public void scene(int pixelX, int pixelY, boolean innermost) {
    pick(pixelX, pixelY, innermost, picked -> picked.ifPresent(this::select));
  }

  @Override
  public void menu(MouseEvent event, int pixelX, int pixelY) {
    pick(
        pixelX,
        pixelY,
        false,
        picked -> {
          // A click on the background selects the whole scene.
          picked.ifPresentOrElse(
              this::select,
              () -> anchors.scene().ifPresent(element -> session.select(element, origin)));
          menu.accept(view, event.getPoint());
        });
  }

  private void pick(
      int pixelX,
      int pixelY,
      boolean innermost,
      Consumer<Optional<PreviewController.Picked>> meant) {
    thread.tell(
        stage -> {
          Optional<PreviewController.Picked> picked = stage.pick(pixelX, pixelY, innermost);
          SwingUtilities.invokeLater(() -> meant.accept(picked));
        });
  }

  private void select(PreviewController.Picked picked) {
    anchors.element(picked).ifPresent(element -> session.select(element, origin));
  }
}
