package org.selectiverenderer.enricher.overview;

import javax.swing.DefaultCellEditor;
import javax.swing.JComboBox;
import javax.swing.text.JTextComponent;

/** The cell editor of a degree: a list of common degrees, or any number from 0 to 1. */
@SuppressWarnings("serial") // never written
final class DegreeCellEditor extends DefaultCellEditor {
  private static final long serialVersionUID = 1L;
  private final JComboBox<String> box;

  DegreeCellEditor() {
    this(new JComboBox<>(new String[] {"", "low", "0.25", "0.5", "0.75", "high"}));
  }

  private DegreeCellEditor(JComboBox<String> box) {
    super(box);
    this.box = box;
    box.setEditable(true);
    setClickCountToStart(2);
  }

  /** Starts editing with a character that the author has typed. */
  void begin(char first) {
    box.requestFocusInWindow();
    JTextComponent text = (JTextComponent) box.getEditor().getEditorComponent();
    text.setText(String.valueOf(first));
    text.requestFocusInWindow();
  }

  /** Ends editing if the text is a degree; otherwise marks the editor and stays open. */
  @Override
  public boolean stopCellEditing() {
    String text = String.valueOf(box.getEditor().getItem());
    boolean degree = CellInput.of(text).isPresent();
    ((javax.swing.JComponent) box).putClientProperty("JComponent.outline", degree ? null : "error");
    box.repaint();
    return degree && super.stopCellEditing();
  }

  @Override
  public void cancelCellEditing() {
    box.putClientProperty("JComponent.outline", null);
    super.cancelCellEditing();
  }

  @Override
  public Object getCellEditorValue() {
    return String.valueOf(box.getEditor().getItem());
  }
}
