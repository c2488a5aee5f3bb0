package org.selectiverenderer.enricher.ratings;

import java.util.List;
import java.util.Optional;
import javax.swing.table.AbstractTableModel;
import org.selectiverenderer.document.ratings.ObjectMatching.Match;

/** Which Switch each object of the table is; the Switch can be corrected. */
@SuppressWarnings("serial") // never written
final class MatchTableModel extends AbstractTableModel {
  private static final long serialVersionUID = 1L;

  /** What stands for an object that is no Switch. */
  static final String NONE = "(leave out)";

  static final int SWITCH = 1;
  private static final List<String> HEADS = List.of("Object in the table", "Switch", "Why");

  private final RatingsModel model;
  private List<Match> rows;

  MatchTableModel(RatingsModel model) {
    this.model = model;
    this.rows = model.matches();
    model.addListener(this::refresh);
  }

  private void refresh() {
    List<Match> before = rows;
    rows = model.matches();
    if (before.size() == rows.size() && !rows.isEmpty()) {
      fireTableRowsUpdated(0, rows.size() - 1);
    } else {
      fireTableDataChanged();
    }
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return HEADS.size();
  }

  @Override
  public String getColumnName(int column) {
    return HEADS.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    Match match = rows.get(row);
    return switch (column) {
      case 0 -> match.object();
      case SWITCH -> match.switchName().orElse(NONE);
      default ->
          switch (match.how()) {
            case SAME_NAME -> "same name";
            case CHOSEN -> "chosen";
            case PROPOSED -> "\u26a0 only similar: choose to use";
            case NONE -> "left out";
          };
    };
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == SWITCH;
  }

  @Override
  public void setValueAt(Object value, int row, int column) {
    String name = String.valueOf(value);
    if (value != null) {
      model.match(rows.get(row).object(), name.equals(NONE) ? Optional.empty() : Optional.of(name));
    }
  }
}
