package org.selectiverenderer.enricher.form;

import java.awt.event.ActionListener;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.component.WrapLayout;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The row with the name of an area or object, and buttons for it as a whole, such as copy and
 * delete.
 */
final class NameFieldRow {
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, wrap 1, hidemode 3", "[grow,fill]"));
  private final JPanel buttons = new JPanel();
  private final FieldBinding field;
  private final boolean writable;

  NameFieldRow(EnricherSession session, NodeCommands nodes, DocumentElement element) {
    writable = session.document().locked().isEmpty();
    JTextField name = new JTextField();
    name.setName("Node name");
    name.setEditable(writable);
    JLabel label = LabelFactory.of(Texts.of("area.name"), name);
    JLabel complaint = LabelFactory.complaint();
    panel.add(label);
    panel.add(name, "wmin 0");
    panel.add(complaint, "wmin 0");
    WrapLayout.in(buttons, 4, 2);
    panel.add(buttons, "wmin 0");
    field =
        FieldBinding.of(
            name,
            complaint,
            new FieldBinding.Source(
                () -> element.def().orElse(""),
                text ->
                    text.isBlank() && element.def().isEmpty()
                        ? Optional.empty()
                        : nodes.rename(element, text)));
    add("area.copy", "area.copy.tip", "Copy node", event -> nodes.copy(element, this));
    add("area.delete", "area.delete.tip", "Delete node", event -> nodes.delete(element));
  }

  /** Adds a button whose text and tooltip have these keys. */
  void add(String text, String tip, String name, ActionListener does) {
    JButton button = new JButton(MnemonicText.of(Texts.of(text)).words());
    button.setToolTipText(Texts.of(tip));
    button.getAccessibleContext().setAccessibleDescription(Texts.of(tip));
    button.setName(name);
    button.setEnabled(writable);
    button.addActionListener(does);
    buttons.add(button);
  }

  JPanel component() {
    return panel;
  }

  FieldBinding field() {
    return field;
  }
}
