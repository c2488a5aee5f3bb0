package org.selectiverenderer.enricher.cost;

import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;
import javax.swing.table.TableModel;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.swing.PlainText;

/**
 * A table of costs. Tooltips show what narrow columns cut off; the table scrolls horizontally only
 * where its columns do not fit at their minimum widths.
 */
final class CostTable extends JTable {
  private static final long serialVersionUID = 1L;

  /**
   * @param name for a screen reader
   */
  CostTable(TableModel model, String name) {
    super(model);
    PlainText.cells(this);
    getAccessibleContext().setAccessibleName(name);
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    getTableHeader().setReorderingAllowed(false);
    setFillsViewportHeight(true);
    setRowHeight(Math.round(getFontMetrics(getFont()).getHeight() * 1.4f));
    for (String key : List.of("F8", "F6")) {
      getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
          .put(KeyStroke.getKeyStroke(key), "none"); // left to the window's menus
    }
  }

  /**
   * Sets preferred and minimum width of a column, in letters.
   *
   * @param letters preferred width
   * @param least minimum width
   */
  CostTable column(int index, int letters, int least) {
    int letter = getFontMetrics(getFont()).charWidth('n');
    TableColumn column = getColumnModel().getColumn(index);
    column.setPreferredWidth(letters * letter);
    column.setMinWidth(least * letter);
    return this;
  }

  /** Does the same for a column of numbers, which are aligned to the right. */
  CostTable numbers(int index, int letters, int least) {
    DefaultTableCellRenderer right = PlainText.only(new DefaultTableCellRenderer());
    right.setHorizontalAlignment(SwingConstants.TRAILING);
    getColumnModel().getColumn(index).setCellRenderer(right);
    return column(index, letters, least);
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return getParent() == null || getParent().getWidth() >= getMinimumSize().width;
  }

  @Override
  public @Nullable String getToolTipText(MouseEvent event) {
    String own = super.getToolTipText(event);
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    return own == null && row >= 0 && getValueAt(row, column) instanceof String text
        ? PlainText.of(text)
        : own;
  }
}
