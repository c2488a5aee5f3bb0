package org.selectiverenderer.enricher.cost;

import javax.swing.DefaultCellEditor;
import javax.swing.JTextField;
import org.selectiverenderer.enricher.text.Texts;

/** The cell editor of a limit. It stays open and marked until the text is a number or empty. */
final class LimitEditor extends DefaultCellEditor {
  private static final long serialVersionUID = 1L;

  LimitEditor() {
    super(new JTextField());
    JTextField field = (JTextField) getComponent();
    field.setHorizontalAlignment(JTextField.TRAILING);
    field.getAccessibleContext().setAccessibleName(Texts.of("cost.limit"));
    field.setToolTipText(Texts.of("cost.limittip"));
  }

  @Override
  public boolean stopCellEditing() {
    JTextField field = (JTextField) getComponent();
    String text = field.getText();
    boolean fits = text.isBlank() || StatesModel.number(text).isPresent();
    field.putClientProperty("JComponent.outline", fits ? null : "error");
    return fits && super.stopCellEditing();
  }

  @Override
  public void cancelCellEditing() {
    ((JTextField) getComponent()).putClientProperty("JComponent.outline", null);
    super.cancelCellEditing();
  }
}
