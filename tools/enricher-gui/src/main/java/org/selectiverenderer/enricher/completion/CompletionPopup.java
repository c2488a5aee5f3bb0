package org.selectiverenderer.enricher.completion;

import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import javax.swing.text.JTextComponent;
import org.selectiverenderer.swing.PlainText;

/**
 * A popup list of completion proposals below a text component, which keeps the focus.
 *
 * @param <T> type of the proposals; shown by {@code toString} unless there is a renderer
 */
public final class CompletionPopup<T> {
  private static final int ROWS = 8;

  private final JTextComponent text;
  private final Consumer<T> taken;
  private final DefaultListModel<T> proposals = new DefaultListModel<>();
  private final JList<T> list = PlainText.entries(new JList<>(proposals));
  private final JPopupMenu popup = new JPopupMenu();

  /**
   * @param name accessible name of the list
   * @param taken called with the accepted proposal
   */
  public CompletionPopup(JTextComponent text, String name, Consumer<T> taken) {
    this.text = text;
    this.taken = taken;
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setFocusable(false);
    list.getAccessibleContext().setAccessibleName(name);
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            take();
          }
        });
    popup.setFocusable(false);
    JScrollPane scroll = new JScrollPane(list);
    scroll.setBorder(null);
    popup.add(scroll);
    text.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            close();
          }
        });
  }

  /** Sets how proposals are rendered. */
  public void renderer(ListCellRenderer<? super T> renderer) {
    list.setCellRenderer(renderer);
  }

  public boolean open() {
    return popup.isVisible();
  }

  public void close() {
    popup.setVisible(false);
  }

  /** The shown proposals in order; for tests. */
  public List<T> shown() {
    return java.util.Collections.list(proposals.elements());
  }

  /**
   * Shows proposals; closes the list where there are none.
   *
   * @param at upper left corner of the popup in the text component
   * @param chosen whether the first is preselected, so that Enter accepts it; a single one is
   *     always
   */
  public void show(List<T> found, Point at, boolean chosen) {
    close(); // Its size is new.
    if (found.isEmpty() || !text.isFocusOwner()) {
      return;
    }
    proposals.clear();
    proposals.addAll(found);
    list.setVisibleRowCount(Math.min(ROWS, found.size()));
    if (chosen || found.size() == 1) {
      choose(0);
    } else {
      list.clearSelection();
    }
    popup.show(text, at.x, at.y);
  }

  /** Handles and consumes the navigation keys while the list is open. */
  public void steer(KeyEvent event) {
    if (!open()) {
      return;
    }
    int selected = list.getSelectedIndex();
    switch (event.getKeyCode()) {
      case KeyEvent.VK_DOWN -> choose(Math.min(selected + 1, proposals.size() - 1));
      case KeyEvent.VK_UP -> choose(Math.max(selected - 1, 0));
      case KeyEvent.VK_PAGE_DOWN -> choose(Math.min(selected + ROWS, proposals.size() - 1));
      case KeyEvent.VK_PAGE_UP -> choose(Math.max(selected - ROWS, 0));
      case KeyEvent.VK_ESCAPE -> close();
      case KeyEvent.VK_ENTER, KeyEvent.VK_TAB -> {
        if (selected < 0) {
          close();
          return; // Enter without a selection only closes the list.
        }
        take();
      }
      default -> {
        return;
      }
    }
    event.consume();
  }

  private void choose(int index) {
    list.setSelectedIndex(index);
    list.ensureIndexIsVisible(index);
  }

  private void take() {
    T choice = list.getSelectedValue();
    close();
    if (choice != null) {
      taken.accept(choice);
    }
  }
}
