package org.selectiverenderer.enricher.overview;

import java.awt.Component;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;
import org.jspecify.annotations.Nullable;

/** Renders a degree with the symbol and the tint of the consistency type. */
final class ConsistencyCell extends DefaultTableCellRenderer {
  private static final long serialVersionUID = 1L;

  private final OverviewTableModel model;

  ConsistencyCell(OverviewTableModel model) {
    this.model = model;
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table,
      @Nullable Object value,
      boolean selected,
      boolean focused,
      int row,
      int column) {
    setBackground(null);
    super.getTableCellRendererComponent(table, value, selected, focused, row, column);
    ConsistencySign sign = model.sign(row, table.convertColumnIndexToModel(column));
    setIcon(sign.icon());
    if (!selected) {
      setBackground(sign.ground(table.getBackground()));
    }
    getAccessibleContext().setAccessibleName((value + " " + sign.words()).strip());
    return this;
  }
}
