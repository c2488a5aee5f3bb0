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
final class PictureClicks implements PictureHands.Clicks {
  private final PictureView view;
  private final PreviewThread thread;
  private final EnricherSession session;
  private final DocumentAnchors anchors;
  private final Object origin;
  private BiConsumer<Component, Point> menu = (over, at) -> {};

  /**
   * @param origin the view that is passed as the origin of the selection
   */
  PictureClicks(PictureView view, PreviewThread thread, EnricherSession session, Object origin) {
    this.view = view;
    this.thread = thread;
    this.session = session;
    this.anchors = new DocumentAnchors(session.document());
    this.origin = origin;
  }

  /** Sets what shows the context menu of the selected node, over a component at a point. */
  void onMenu(BiConsumer<Component, Point> shown) {
    menu = shown;
  }

  @Override
  public void label(PreviewFrame.Label label) {
    select(
        new PreviewStage.Picked(
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
      int pixelX, int pixelY, boolean innermost, Consumer<Optional<PreviewStage.Picked>> meant) {
    thread.tell(
        stage -> {
          Optional<PreviewStage.Picked> picked = stage.pick(pixelX, pixelY, innermost);
          SwingUtilities.invokeLater(() -> meant.accept(picked));
        });
  }

  private void select(PreviewStage.Picked picked) {
    anchors.element(picked).ifPresent(element -> session.select(element, origin));
  }
}
