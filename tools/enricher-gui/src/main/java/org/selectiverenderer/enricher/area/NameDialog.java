package org.selectiverenderer.enricher.area;

import java.awt.Component;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.event.AncestorEvent;
import javax.swing.event.AncestorListener;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/** Asks for a node name in a dialog. */
public final class NameDialog implements NamePrompt {
  private final Supplier<Component> owner;

  /**
   * @param owner the component over which the dialog opens
   */
  public NameDialog(Supplier<Component> owner) {
    this.owner = owner;
  }

  @Override
  public Optional<String> ask(
      String title, String proposal, Function<String, Optional<String>> complaint) {
    String name = proposal;
    String wrong = " ";
    while (true) {
      JTextField field = new JTextField(name, 24);
      field.setName("New name");
      field.selectAll();
      focus(field);
      JLabel label = new JLabel(Texts.of("area.name"));
      label.setLabelFor(field);
      JPanel panel = new JPanel(new MigLayout("insets 0, wrap 1, wmin 320", "[grow,fill]"));
      panel.add(label);
      panel.add(field);
      JLabel says = PlainText.only(new JLabel(PlainText.of(wrong)));
      says.putClientProperty("FlatLaf.styleClass", "small");
      panel.add(says, "wmin 0");
      int answer =
          JOptionPane.showConfirmDialog(
              owner.get(), panel, title, JOptionPane.OK_CANCEL_OPTION, JOptionPane.PLAIN_MESSAGE);
      if (answer != JOptionPane.OK_OPTION) {
        return Optional.empty();
      }
      name = field.getText().strip();
      Optional<String> why = complaint.apply(name);
      if (why.isEmpty()) {
        return Optional.of(name);
      }
      wrong = why.get();
    }
  }

  /** Gives the field the initial focus, which the dialog would give to its button. */
  private static void focus(JComponent field) {
    field.addAncestorListener(
        new AncestorListener() {
          @Override
          public void ancestorAdded(AncestorEvent event) {
            SwingUtilities.invokeLater(field::requestFocusInWindow);
          }

          @Override
          public void ancestorRemoved(AncestorEvent event) {
            // The dialog is gone.
          }

          @Override
          public void ancestorMoved(AncestorEvent event) {
            // Stays where the author puts it.
          }
        });
  }
}
