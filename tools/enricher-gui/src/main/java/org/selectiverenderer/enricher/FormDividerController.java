package org.selectiverenderer.enricher;

import java.util.Optional;
import javax.swing.JSplitPane;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Controls the divider between the views and the form: where the author left it, but with a narrow
 * form until the first node is selected, so that the preview has the room.
 */
final class FormDividerController {
  /** Width in pixels of the form before a node is selected. */
  private static final int EMPTY = 190;

  /** Least width in pixels of the views. */
  private static final int VIEWS = 120;

  private final JSplitPane split;
  private final EnricherSession session;
  private final SelectionListener onSelection = this::selected;
  private Optional<Integer> waiting = Optional.empty();

  /**
   * @param split the split pane with the views at the left and the form at the right
   */
  FormDividerController(JSplitPane split, EnricherSession session) {
    this.split = split;
    this.session = session;
    session.addSelectionListener(onSelection);
  }

  /**
   * Places the divider.
   *
   * @param all pixels of views and form together
   * @param wanted pixels of the form
   */
  void layOut(int all, int wanted) {
    if (session.selection().isEmpty() && wanted > EMPTY) {
      waiting = Optional.of(wanted);
      put(all, EMPTY);
    } else {
      waiting = Optional.empty();
      put(all, wanted);
    }
  }

  private void put(int all, int form) {
    split.setDividerLocation(Math.max(VIEWS, all - form));
  }

  /** Widens the form for its first node, unless the author has moved the divider meanwhile. */
  private void selected(Optional<DocumentElement> element, Object origin) {
    if (element.isPresent()) {
      boolean moved = present() != EMPTY;
      waiting.filter(wanted -> !moved).ifPresent(wanted -> put(split.getWidth(), wanted));
      waiting = Optional.empty();
    }
  }

  private int present() {
    return split.getWidth() - split.getDividerLocation();
  }

  /** The form's width in pixels that the settings remember. */
  int width() {
    return waiting.filter(wanted -> present() == EMPTY).orElseGet(this::present);
  }

  void dispose() {
    session.removeSelectionListener(onSelection);
  }
}
