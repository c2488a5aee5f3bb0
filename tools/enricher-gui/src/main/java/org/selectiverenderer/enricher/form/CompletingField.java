package org.selectiverenderer.enricher.form;

import java.awt.Point;
import java.awt.event.ActionEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.selectiverenderer.enricher.completion.CompletionPopup;

/**
 * A text field that proposes completions while one types, or on Down and Ctrl+Space.
 *
 * @param <T> type of the proposals, which are shown by {@code toString}
 */
abstract class CompletingField<T> extends JTextField {
  private static final long serialVersionUID = 1L;

  private final transient CompletionPopup<T> proposals;

  /**
   * @param listName accessible name of the list of proposals
   */
  CompletingField(String listName) {
    proposals = new CompletionPopup<>(this, listName, this::take);
    addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (!proposals.open() && event.getKeyCode() == KeyEvent.VK_DOWN) {
              propose(true);
              event.consume();
            } else {
              proposals.steer(event);
            }
          }

          @Override
          public void keyTyped(KeyEvent event) {
            // A key with Ctrl, such as Ctrl+Space itself, types nothing.
            boolean types = !event.isControlDown() && !event.isMetaDown();
            if (types && (!Character.isISOControl(event.getKeyChar()) || erases(event))) {
              SwingUtilities.invokeLater(() -> propose(false));
            }
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

  private static boolean erases(KeyEvent event) {
    return event.getKeyChar() == '\b';
  }

  /** Whether the list of proposals is open. */
  boolean proposing() {
    return proposals.open();
  }

  /**
   * Returns the proposals for the text before the caret.
   *
   * @param asked whether the author asked for proposals, also without a typed letter
   */
  abstract List<T> proposals(boolean asked);

  /** Puts an accepted proposal into the text. */
  abstract void take(T proposal);

  /** Shows the proposals for the text before the caret. */
  final void propose(boolean asked) {
    proposals.show(proposals(asked), new Point(0, getHeight()), asked);
  }
}
