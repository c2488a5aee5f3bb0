package org.selectiverenderer.enricher.overview;

import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

/** Asks for the name of a schema. */
final class SchemaNaming {
  private final JComponent parent;

  SchemaNaming(JComponent parent) {
    this.parent = parent;
  }

  /**
   * The name that the author gives.
   *
   * @return empty if they think better of it
   */
  Optional<String> ask(String title, String question, String proposed) {
    JTextField field = new JTextField(proposed, 24);
    field.getAccessibleContext().setAccessibleName(question);
    field.selectAll();
    SwingUtilities.invokeLater(field::requestFocusInWindow);
    int answer =
        JOptionPane.showConfirmDialog(
            parent,
            new Object[] {question, field},
            title,
            JOptionPane.OK_CANCEL_OPTION,
            JOptionPane.PLAIN_MESSAGE);
    return answer == JOptionPane.OK_OPTION ? Optional.of(field.getText()) : Optional.empty();
  }
}
