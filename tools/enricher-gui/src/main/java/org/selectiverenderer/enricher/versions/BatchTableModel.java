package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.table.AbstractTableModel;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.versions.BatchVersionsEdit;
import org.selectiverenderer.authoring.versions.VersionCandidate;
import org.selectiverenderer.authoring.versions.VersionCandidate.Remark;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;

/** The table of objects to make versions of: the author ticks them and sets names and goals. */
@SuppressWarnings("serial") // never written
final class BatchTableModel extends AbstractTableModel {
  private static final long serialVersionUID = 1L;

  static final int CHOSEN = 0;
  static final int NAME = 1;
  static final int TYPE = 2;
  static final int POLYGONS = 3;
  static final int GOAL = 4;
  static final int REMARK = 5;

  private static final List<String> HEADS =
      List.of("chosen", "name", "type", "polygons", "goal", "remark");

  private record Row(VersionCandidate object, boolean chosen, String goal) {}

  private final List<Row> rows = new ArrayList<>();

  /** The rows that the author has changed, by where their objects start, shown or not. */
  private final Map<Integer, Row> changed = new HashMap<>();

  private transient Consumer<String> onRefused = sentence -> {};
  private BatchGoal.Kind kind = BatchGoal.Kind.PERCENT;

  /** Sets what is told why a name or goal was not taken. */
  void onRefused(Consumer<String> listener) {
    onRefused = listener;
  }

  /**
   * Shows objects, as the author has changed them.
   *
   * @param fewest objects with fewer polygons are left out
   * @param goal the goals of all
   */
  void show(List<VersionCandidate> objects, int fewest, String goal) {
    rows.clear();
    for (VersionCandidate object : objects) {
      if (object.polygons() >= fewest) {
        Row fresh = new Row(object, object.proposed(fewest), goal);
        rows.add(changed.getOrDefault(object.start(), fresh));
      }
    }
    fireTableDataChanged();
  }

  /** Sets the goals of all objects. */
  void goals(BatchGoal.Kind ofAll, String goal) {
    kind = ofAll;
    rows.replaceAll(row -> new Row(row.object(), row.chosen(), goal));
    changed.replaceAll((start, row) -> new Row(row.object(), row.chosen(), goal));
    if (!rows.isEmpty()) {
      fireTableRowsUpdated(0, rows.size() - 1);
    }
  }

  /** Ticks or unticks all objects that can have versions. */
  void choose(boolean all) {
    rows.replaceAll(row -> new Row(row.object(), all && row.object().possible(), row.goal()));
    rows.forEach(row -> changed.put(row.object().start(), row));
    if (!rows.isEmpty()) {
      fireTableRowsUpdated(0, rows.size() - 1);
    }
  }

  /** Returns the ticked objects with their goals. */
  List<BatchVersionsEdit.Item> chosen() {
    return rows.stream()
        .filter(Row::chosen)
        .map(
            row ->
                new BatchVersionsEdit.Item(
                    row.object(), BatchGoal.read(kind, row.goal()).targets()))
        .toList();
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
    return Texts.of("manyversions.column." + HEADS.get(column));
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return switch (column) {
      case CHOSEN -> Boolean.class;
      case POLYGONS -> Integer.class;
      default -> String.class;
    };
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    VersionCandidate object = rows.get(row).object();
    return switch (column) {
      case CHOSEN, GOAL -> object.possible();
      case NAME -> object.possible() && object.def().isEmpty();
      default -> false;
    };
  }

  @Override
  public Object getValueAt(int index, int column) {
    Row row = rows.get(index);
    return switch (column) {
      case CHOSEN -> row.chosen();
      case NAME -> row.object().name();
      case TYPE -> row.object().type();
      case POLYGONS -> row.object().polygons();
      case GOAL -> row.goal();
      default -> remark(row.object());
    };
  }

  private static String remark(VersionCandidate object) {
    if (object.remark() == Remark.IMPOSSIBLE) {
      return Remarks.shown(object.obstacle());
    }
    String said =
        switch (object.remark()) {
          case NONE, FEW, IMPOSSIBLE -> "";
          case FLAT -> Texts.of("manyversions.flat");
          case AROUND -> Texts.of("manyversions.around");
          case SHARED -> Texts.of("manyversions.shared");
          case VERSIONS -> Texts.of("manyversions.versions");
        };
    return said.isEmpty() && object.def().isEmpty() ? Texts.of("manyversions.named") : said;
  }

  /**
   * Takes what the author has set; a name or goal that is not valid leaves the cell as it was,
   * which is told.
   */
  @Override
  public void setValueAt(Object value, int index, int column) {
    Row row = rows.get(index);
    String text = String.valueOf(value).strip();
    String refused =
        switch (column) {
          case NAME ->
              UniqueNameGenerator.allowed(text) ? "" : Texts.of("manyversions.noname", text);
          case GOAL -> BatchGoal.read(kind, text).fault();
          default -> "";
        };
    if (refused.isEmpty()) {
      Row now =
          switch (column) {
            case CHOSEN -> new Row(row.object(), Boolean.TRUE.equals(value), row.goal());
            case NAME -> new Row(row.object().named(text), row.chosen(), row.goal());
            case GOAL -> new Row(row.object(), row.chosen(), text);
            default -> row;
          };
      rows.set(index, now);
      changed.put(now.object().start(), now);
    }
    fireTableRowsUpdated(index, index);
    if (!refused.isEmpty()) {
      onRefused.accept(refused);
    }
  }
}
