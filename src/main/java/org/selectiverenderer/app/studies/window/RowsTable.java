package org.selectiverenderer.app.studies.window;

import java.awt.Component;
import java.awt.Font;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.function.IntPredicate;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.TableCellRenderer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.swing.PlainText;

/** A table of texts whose cells show their whole text as a tip; Tab leaves it. */
final class RowsTable extends JTable {
  private static final long serialVersionUID = 1;

  private transient IntPredicate bold = row -> false;

  /**
   * @param key of the accessible name
   * @param widths of the columns, in letters
   */
  RowsTable(RowsModel model, String key, int... widths) {
    super(model);
    setName(key);
    getAccessibleContext().setAccessibleName(StudyTexts.of(key));
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    setFillsViewportHeight(true);
    getTableHeader().setReorderingAllowed(false);
    PlainText.cells(this);
    int letter = getFontMetrics(getFont()).charWidth('n');
    for (int i = 0; i < widths.length; i++) {
      getColumnModel().getColumn(i).setPreferredWidth(widths[i] * letter);
    }
    // Tab goes on to the next control, as the table is not edited; arrows move within it.
    getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(KeyEvent.VK_TAB, 0), "none");
    getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(KeyEvent.VK_TAB, KeyEvent.SHIFT_DOWN_MASK), "none");
  }

  /** Sets which rows are bold. */
  void bold(IntPredicate which) {
    bold = which;
    repaint();
  }

  @Override
  public Component prepareRenderer(TableCellRenderer renderer, int row, int column) {
    Component cell = super.prepareRenderer(renderer, row, column);
    cell.setFont(bold.test(row) ? getFont().deriveFont(Font.BOLD) : getFont());
    return cell;
  }

  @Override
  public @Nullable String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    if (row < 0 || column < 0) {
      return null;
    }
    String text = String.valueOf(getValueAt(row, column));
    return text.isEmpty() ? null : PlainText.of(text);
  }
}
