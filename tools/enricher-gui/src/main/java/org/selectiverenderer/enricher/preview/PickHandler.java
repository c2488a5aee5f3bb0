package org.selectiverenderer.enricher.preview;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.placement.ClickSelection;
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
  private final ClickSelection clicks;
  private @Nullable MeasureOverlay measuring;
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
    this.clicks = new ClickSelection(session);
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

  /** Sets what takes clicks instead while it is active. */
  void measuring(MeasureOverlay overlay) {
    measuring = overlay;
  }

  @Override
  public void scene(int pixelX, int pixelY, PreviewInputController.Picking picking) {
    MeasureOverlay measure = measuring;
    if (measure != null && measure.active()) {
      measure.click(pixelX, pixelY);
      return;
    }
    pick(
        pixelX,
        pixelY,
        picking == PreviewInputController.Picking.INNERMOST,
        picked ->
            picked
                .flatMap(anchors::element)
                .ifPresent(
                    element -> {
                      if (picking == PreviewInputController.Picking.ANOTHER) {
                        clicks.toggle(element, origin);
                      } else if (picking == PreviewInputController.Picking.OBJECT) {
                        clicks.select(element, origin);
                      } else {
                        session.select(element, origin);
                      }
                    }));
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
              this::selectForMenu,
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

  /** Selects what was clicked on, unless it is among several selected nodes, which stay so. */
  private void selectForMenu(PreviewController.Picked picked) {
    anchors
        .element(picked)
        .filter(element -> !clicks.among(element))
        .ifPresent(element -> session.select(element, origin));
  }

  private void select(PreviewController.Picked picked) {
    anchors.element(picked).ifPresent(element -> session.select(element, origin));
  }
}
