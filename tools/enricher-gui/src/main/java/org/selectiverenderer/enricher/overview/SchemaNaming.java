package org.selectiverenderer.enricher.overview;

import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.JTextField;

/** Asks for the name of a schema in a dialog. */
final class SchemaNaming {
  private final JComponent parent;

  SchemaNaming(JComponent parent) {
    this.parent = parent;
  }

  /**
   * Returns the name that the author types.
   *
   * @return empty if the author cancels
   */
  Optional<String> ask(String title, String question, String proposed) {
    JTextField field = new JTextField(proposed, 24);
    field.getAccessibleContext().setAccessibleName(question);
    field.selectAll();
    FieldFirst pane = new FieldFirst(question, field);
    JDialog dialog = pane.createDialog(parent, title);
    dialog.setVisible(true);
    dialog.dispose();
    return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue())
        ? Optional.of(field.getText())
        : Optional.empty();
  }

  /**
   * An option pane that focuses its field whenever the dialog gets the focus; a request before that
   * is lost where a window manager gives the focus later.
   */
  @SuppressWarnings("serial") // never written
  private static final class FieldFirst extends JOptionPane {
    private static final long serialVersionUID = 1L;

    private final JTextField field;

    FieldFirst(String question, JTextField field) {
      super(new Object[] {question, field}, PLAIN_MESSAGE, OK_CANCEL_OPTION);
      this.field = field;
    }

    @Override
    public void selectInitialValue() {
      super.selectInitialValue(); // OK stays what Enter presses
      field.requestFocusInWindow();
    }
  }
}
