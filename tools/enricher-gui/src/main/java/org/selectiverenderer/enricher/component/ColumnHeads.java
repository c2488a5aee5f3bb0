package org.selectiverenderer.enricher.component;

import com.formdev.flatlaf.util.UIScale;
import javax.swing.JTable;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;

/** Columns of a table that are wide enough for their heads, in any language. */
public final class ColumnHeads {
  /** Room beside a head, as letters of a scaled screen are a bit wider than they measure. */
  private static final int PADDING = 6;

  private ColumnHeads() {}

  /** Makes no column narrower than its head; the wishes for wider ones stay. */
  public static void fit(JTable table) {
    TableCellRenderer heads = table.getTableHeader().getDefaultRenderer();
    for (int i = 0; i < table.getColumnCount(); i++) {
      TableColumn column = table.getColumnModel().getColumn(i);
      int width =
          heads
                  .getTableCellRendererComponent(
                      table, column.getHeaderValue(), false, false, -1, i)
                  .getPreferredSize()
                  .width
              + UIScale.scale(PADDING);
      column.setMinWidth(Math.max(column.getMinWidth(), width));
      column.setPreferredWidth(Math.max(column.getPreferredWidth(), width));
    }
  }
}
