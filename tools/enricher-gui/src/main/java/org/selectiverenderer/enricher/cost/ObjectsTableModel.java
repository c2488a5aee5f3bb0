package org.selectiverenderer.enricher.cost;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.polygon.PolygonContributions;
import org.selectiverenderer.polygon.PolygonContributions.ObjectShare;

/** The table model of the polygons that each object contributes to a state, the largest first. */
final class ObjectsTableModel extends RowTableModel<ObjectShare> {
  static final int OBJECT = 0;
  static final int POLYGONS = 1;
  static final int PERCENT = 2;
  static final int SHOWN = 3;
  static final int VERSIONS = 4;
  private static final long serialVersionUID = 1L;

  private long all;

  ObjectsTableModel() {
    super(
        Texts.of("cost.object"),
        Texts.of("cost.polygons"),
        Texts.of("cost.share"),
        Texts.of("cost.shown"),
        Texts.of("cost.versions"));
  }

  void show(Optional<PolygonContributions> shares) {
    all = shares.map(PolygonContributions::polygons).orElse(0L);
    List<ObjectShare> sorted =
        shares.map(PolygonContributions::objects).orElse(List.of()).stream()
            .sorted(Comparator.comparingLong(ObjectShare::polygons).reversed())
            .toList();
    update(sorted);
  }

  @Override
  protected Object cell(ObjectShare row, int column) {
    return switch (column) {
      case OBJECT ->
          row.places() == 1 ? row.name() : Texts.of("cost.places", row.name(), "" + row.places());
      case POLYGONS -> DecimalFormatter.grouped(row.polygons());
      case PERCENT ->
          all == 0 ? "" : DecimalFormatter.fixed(100.0 * row.polygons() / all, 1) + " %";
      case SHOWN ->
          row.version() < 0 || row.version() >= row.versions().size()
              ? Texts.of("cost.none")
              : Texts.of(
                  "cost.nth",
                  Integer.toString(row.version() + 1),
                  Integer.toString(row.versions().size()));
      default ->
          row.versions().stream()
              .map(DecimalFormatter::grouped)
              .collect(Collectors.joining(" \u00b7 "));
    };
  }

  /** The row of an object; -1 for none. */
  int row(String name) {
    for (int row = 0; row < getRowCount(); row++) {
      if (row(row).name().equals(name)) {
        return row;
      }
    }
    return -1;
  }
}
