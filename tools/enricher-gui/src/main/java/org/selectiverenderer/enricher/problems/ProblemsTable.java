package org.selectiverenderer.enricher.problems;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.event.MouseEvent;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/** The table of problems; asks its model only for rows in view. */
final class ProblemsTable extends JTable {
  private static final long serialVersionUID = 1L;

  ProblemsTable(ProblemsTableModel model) {
    super(model);
    PlainText.cells(this);
    getAccessibleContext().setAccessibleName(Texts.of("problems.table"));
    setFillsViewportHeight(true);
    setShowGrid(false);
    getTableHeader().setReorderingAllowed(false);
    TableColumn severity = getColumnModel().getColumn(ProblemsTableModel.SEVERITY);
    severity.setCellRenderer(new SeverityRenderer());
    width(ProblemsTableModel.MESSAGE, 640);
    width(ProblemsTableModel.PLACE, 280);
    width(ProblemsTableModel.FIX, 140);
    severityWidth();
    addPropertyChangeListener("font", event -> severityWidth());
  }

  /** Sets the severity column to the width of the longest word in the present language. */
  private void severityWidth() {
    TableColumn column = getColumnModel().getColumn(ProblemsTableModel.SEVERITY);
    TableCellRenderer cells = column.getCellRenderer();
    TableCellRenderer head = getTableHeader().getDefaultRenderer();
    int width = width(head, column.getHeaderValue());
    for (Severity each : Severity.values()) {
      width = Math.max(width, width(cells, each));
    }
    column.setMinWidth(width);
    column.setMaxWidth(width);
    column.setPreferredWidth(width);
  }

  private int width(TableCellRenderer renderer, Object value) {
    Component cell =
        renderer.getTableCellRendererComponent(
            this, value, false, false, 0, ProblemsTableModel.SEVERITY);
    return cell.getPreferredSize().width + 2 * getColumnModel().getColumnMargin();
  }

  private void width(int column, int pixels) {
    getColumnModel().getColumn(column).setPreferredWidth(UIScale.scale(pixels));
  }

  @Override
  public @Nullable String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    return row < 0
        ? null
        : PlainText.of(String.valueOf(getValueAt(row, ProblemsTableModel.MESSAGE)));
  }

  private static final class SeverityRenderer extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      Severity severity = (Severity) value;
      setIcon(new SeverityIcon(severity));
      setText(SeverityIcon.word(severity));
      return this;
    }
  }
}
