package org.selectiverenderer.enricher;

import java.util.Optional;
import javax.swing.JSplitPane;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * How wide the form beside the views is: as the author left it, but narrow until the first node is
 * selected, so that what is looked at first has the room.
 */
final class FormColumn {
  /** Pixels of a form that only says what can be done. */
  private static final int EMPTY = 190;

  /** Pixels that the views have at least. */
  private static final int VIEWS = 120;

  private final JSplitPane split;
  private final EnricherSession session;
  private final SelectionListener onSelection = this::selected;
  private Optional<Integer> waiting = Optional.empty();

  /**
   * @param split with the views at the left and the form at the right
   */
  FormColumn(JSplitPane split, EnricherSession session) {
    this.split = split;
    this.session = session;
    session.addSelectionListener(onSelection);
  }

  /**
   * Puts the border.
   *
   * @param all pixels of both
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

  /** The form's first node; a border that the author has moved meanwhile stays. */
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

  /** The form's width, in pixels, for the next time. */
  int width() {
    return waiting.filter(wanted -> present() == EMPTY).orElseGet(this::present);
  }

  void dispose() {
    session.removeSelectionListener(onSelection);
  }
}
