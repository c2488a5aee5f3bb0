package org.selectiverenderer.enricher.form;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JTextField;
import javax.swing.KeyStroke;

/** A line of schemas, completed from those that the scene knows: Ctrl+Space or Down lists them. */
final class SchemaField {
  private static final int MOST = 12;

  private final JTextField field = new JTextField();
  private final Supplier<List<String>> known;
  private final Consumer<List<String>> chosen;
  private List<String> shown = List.of();

  SchemaField(
      String name, String help, Supplier<List<String>> known, Consumer<List<String>> chosen) {
    this.known = known;
    this.chosen = chosen;
    field.getAccessibleContext().setAccessibleName(name);
    field.setToolTipText("<html><body width=260>" + help + " (Ctrl+Space lists those known)");
    field.putClientProperty("JTextField.placeholderText", "none");
    field.addActionListener(event -> commit());
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent e) {
            commit();
          }
        });
    bind(KeyStroke.getKeyStroke(KeyEvent.VK_DOWN, 0));
    bind(KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, KeyEvent.CTRL_DOWN_MASK));
  }

  private void bind(KeyStroke key) {
    field.getInputMap().put(key, "propose");
    field.getActionMap().put("propose", new Propose(this::propose));
  }

  private static final class Propose extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private final transient Runnable work;

    Propose(Runnable work) {
      this.work = work;
    }

    @Override
    public void actionPerformed(ActionEvent e) {
      work.run();
    }
  }

  JTextField component() {
    return field;
  }

  /** Shows schemas, unless the author is typing others. */
  void show(List<String> schemas) {
    boolean typing = !SchemaCompletion.parse(field.getText()).equals(shown);
    boolean same = shown.equals(schemas);
    shown = schemas;
    if (!(typing && same && field.isFocusOwner())) {
      field.setText(SchemaCompletion.text(schemas));
    }
  }

  /** Takes what is typed over. */
  void commit() {
    List<String> typed = SchemaCompletion.parse(field.getText());
    if (!typed.equals(shown)) {
      shown = typed;
      chosen.accept(typed);
    }
  }

  private void propose() {
    String line = field.getText();
    int caret = field.getCaretPosition();
    List<String> proposals = SchemaCompletion.proposals(line, caret, known.get());
    JPopupMenu menu = new JPopupMenu();
    menu.getAccessibleContext().setAccessibleName("Schemas of the scene");
    for (String schema : proposals.subList(0, Math.min(MOST, proposals.size()))) {
      JMenuItem item = new JMenuItem(schema);
      item.addActionListener(
          event -> {
            field.setText(SchemaCompletion.accept(line, caret, schema));
            commit();
            field.requestFocusInWindow();
          });
      menu.add(item);
    }
    if (!proposals.isEmpty()) {
      menu.show(field, 0, field.getHeight());
    }
  }
}
