package org.selectiverenderer.enricher.form;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;

/**
 * A text of schemas separated by commas that proposes those which the scene knows: while one types,
 * or on Ctrl+Space. Down and Up choose, Enter takes, Escape closes.
 */
final class SchemasField extends JTextField {
  private static final long serialVersionUID = 1L;
  private static final int ROWS = 8;

  private final transient Supplier<List<String>> known;
  private final DefaultListModel<String> proposals = new DefaultListModel<>();
  private final JList<String> list = new JList<>(proposals);
  private final JPopupMenu popup = new JPopupMenu();

  SchemasField(Supplier<List<String>> known) {
    this.known = known;
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setFocusable(false);
    list.getAccessibleContext().setAccessibleName("Schemas of the scene");
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
    addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            steer(event);
          }

          @Override
          public void keyTyped(KeyEvent event) {
            if (!Character.isISOControl(event.getKeyChar()) || event.getKeyChar() == '\b') {
              SwingUtilities.invokeLater(() -> propose(false));
            }
          }
        });
    addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            popup.setVisible(false);
          }
        });
    getInputMap().put(KeyStroke.getKeyStroke("ctrl SPACE"), "propose");
    getActionMap()
        .put(
            "propose",
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                propose(true);
              }
            });
  }

  private void steer(KeyEvent event) {
    if (!popup.isVisible()) {
      if (event.getKeyCode() == KeyEvent.VK_DOWN) {
        propose(true);
        event.consume();
      }
      return;
    }
    int selected = list.getSelectedIndex();
    switch (event.getKeyCode()) {
      case KeyEvent.VK_DOWN -> choose(Math.min(selected + 1, proposals.size() - 1));
      case KeyEvent.VK_UP -> choose(Math.max(selected - 1, 0));
      case KeyEvent.VK_ESCAPE -> popup.setVisible(false);
      case KeyEvent.VK_ENTER -> {
        if (selected < 0) {
          popup.setVisible(false);
          return; // Enter without a choice is done with the list.
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

  /**
   * Shows what may stand at the caret.
   *
   * @param asked whether the author wants proposals even before typing
   */
  private void propose(boolean asked) {
    int caret = getCaretPosition();
    List<String> found = SchemaList.proposals(getText(), caret, known.get());
    boolean begun = caret > 0 && Character.isLetterOrDigit(getText().charAt(caret - 1));
    boolean done = found.size() == 1 && getText().substring(0, caret).endsWith(found.get(0));
    if (!isFocusOwner() || found.isEmpty() || done || !asked && !begun) {
      popup.setVisible(false);
      return;
    }
    proposals.clear();
    proposals.addAll(found);
    list.setVisibleRowCount(Math.min(ROWS, found.size()));
    if (asked) {
      choose(0);
    } else {
      list.clearSelection();
    }
    popup.setVisible(false); // Its size is new.
    popup.show(this, 0, getHeight());
  }

  private void take() {
    String schema = list.getSelectedValue();
    popup.setVisible(false);
    if (schema != null) {
      SchemaList.Completed completed = SchemaList.complete(getText(), getCaretPosition(), schema);
      setText(completed.text());
      setCaretPosition(completed.caret());
    }
  }
}
