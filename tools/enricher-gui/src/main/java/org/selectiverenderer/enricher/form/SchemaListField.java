package org.selectiverenderer.enricher.form;

import java.awt.Point;
import java.awt.event.ActionEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.selectiverenderer.enricher.completion.CompletionPopup;
import org.selectiverenderer.enricher.text.Texts;

/**
 * A text field for schemas separated by commas that proposes the schemas of the scene while one
 * types, or on Ctrl+Space.
 */
final class SchemaListField extends JTextField {
  private static final long serialVersionUID = 1L;

  private final transient Supplier<List<String>> known;
  private final transient CompletionPopup<String> proposals;

  SchemaListField(Supplier<List<String>> known) {
    this.known = known;
    proposals = new CompletionPopup<>(this, Texts.of("form.known"), this::take);
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
   * Shows the proposals for the name at the caret.
   *
   * @param asked whether the author asked for proposals, also without a typed letter
   */
  private void propose(boolean asked) {
    int caret = getCaretPosition();
    List<String> found = SchemaListFormat.proposals(getText(), caret, known.get());
    boolean begun = caret > 0 && Character.isLetterOrDigit(getText().charAt(caret - 1));
    boolean done = found.size() == 1 && getText().substring(0, caret).endsWith(found.get(0));
    boolean wanted = !done && (asked || begun);
    proposals.show(wanted ? found : List.of(), new Point(0, getHeight()), asked);
  }

  private void take(String schema) {
    SchemaListFormat.Completed completed =
        SchemaListFormat.complete(getText(), getCaretPosition(), schema);
    setText(completed.text());
    setCaretPosition(completed.caret());
  }
}
