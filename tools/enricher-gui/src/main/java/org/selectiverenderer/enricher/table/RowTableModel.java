package org.selectiverenderer.enricher.table;

import java.util.List;
import javax.swing.table.AbstractTableModel;

/**
 * A table model with fixed columns and a list of rows, each of which is one value.
 *
 * @param <R> type of a row
 */
@SuppressWarnings("serial") // never written
public abstract class RowTableModel<R> extends AbstractTableModel {
  private static final long serialVersionUID = 1L;

  private final List<String> heads;
  private List<R> rows = List.of();

  /**
   * @param heads the column names
   */
  protected RowTableModel(String... heads) {
    this.heads = List.of(heads);
  }

  /** The value of a cell. */
  protected abstract Object cell(R row, int column);

  /** Replaces all rows, which clears the selection. */
  protected final void show(List<R> fresh) {
    rows = List.copyOf(fresh);
    fireTableDataChanged();
  }

  /** Updates the rows; the selection stays if their number is the same. */
  protected final void update(List<R> fresh) {
    if (fresh.size() == rows.size() && !rows.isEmpty()) {
      rows = List.copyOf(fresh);
      fireTableRowsUpdated(0, rows.size() - 1);
    } else {
      show(fresh);
    }
  }

  public final R row(int row) {
    return rows.get(row);
  }

  @Override
  public final int getRowCount() {
    return rows.size();
  }

  @Override
  public final int getColumnCount() {
    return heads.size();
  }

  @Override
  public final String getColumnName(int column) {
    return heads.get(column);
  }

  @Override
  public final Object getValueAt(int row, int column) {
    return cell(rows.get(row), column);
  }
}
