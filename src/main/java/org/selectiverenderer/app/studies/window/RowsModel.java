package org.selectiverenderer.app.studies.window;

import java.util.List;
import javax.swing.table.AbstractTableModel;

/** Rows of texts under translated heads; nobody edits them. */
final class RowsModel extends AbstractTableModel {
  private static final long serialVersionUID = 1;

  private final String[] heads;
  private transient List<List<String>> rows = List.of();

  /**
   * @param keys of the heads
   */
  RowsModel(String... keys) {
    heads = new String[keys.length];
    for (int i = 0; i < keys.length; i++) {
      heads[i] = StudyTexts.of(keys[i]);
    }
  }

  /** Shows other rows, of which each has a cell for each head; the same rows change nothing. */
  void rows(List<List<String>> now) {
    if (!now.equals(rows)) {
      rows = List.copyOf(now);
      fireTableDataChanged();
    }
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return heads.length;
  }

  @Override
  public String getColumnName(int column) {
    return heads[column];
  }

  @Override
  public Object getValueAt(int row, int column) {
    return rows.get(row).get(column);
  }
}
