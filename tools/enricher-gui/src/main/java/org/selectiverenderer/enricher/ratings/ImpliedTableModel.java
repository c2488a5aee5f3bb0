package org.selectiverenderer.enricher.ratings;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.ratings.RatingPlan;
import org.selectiverenderer.document.ratings.RatingPlan.Implied;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/** What the ratings imply: their means, the bands of thesis 5.1, and the metadata that follows. */
@SuppressWarnings("serial") // never written
final class ImpliedTableModel extends RowTableModel<ImpliedTableModel.Row> {
  private static final long serialVersionUID = 1L;

  record Row(String object, String schema, String mean, String count, String band, String implied) {
    String cell(int column) {
      return switch (column) {
        case 0 -> object;
        case 1 -> schema;
        case 2 -> mean;
        case 3 -> count;
        case 4 -> band;
        default -> implied;
      };
    }
  }

  private final RatingsModel model;

  ImpliedTableModel(RatingsModel model) {
    super("Switch", "Schema", "Mean", "Ratings", "Band", "Implied metadata");
    this.model = model;
    model.addListener(this::refresh);
    refresh();
  }

  private void refresh() {
    List<Row> fresh = new ArrayList<>();
    model.plan().ifPresent(plan -> add(plan, fresh));
    show(fresh);
  }

  private static void add(RatingPlan plan, List<Row> rows) {
    for (RatingPlan.Row row : plan.rows()) {
      String name = row.node().name();
      for (Implied implied : row.schemas()) {
        rows.add(
            new Row(
                name,
                implied.schema(),
                String.format(Locale.ROOT, "%.2f", implied.mean().value()),
                String.valueOf(implied.mean().count()),
                band(implied.mean().band()),
                implied
                    .choice()
                    .map(choice -> metadata(choice, row.choices()))
                    .orElse("none: as in the room around it")));
      }
      if (row.object().isEmpty()) {
        int last = row.choices().size() - 1;
        rows.add(
            new Row(
                name,
                String.join(", ", row.choices().get(last).schemas()),
                "",
                "0",
                "not rated",
                metadata(last, row.choices()) + ", as expected in its room"));
      }
    }
    plan.sensors()
        .forEach(
            wish ->
                rows.add(
                    new Row(
                        wish.node().name(),
                        String.join(", ", wish.schemas().enter()),
                        "",
                        "",
                        "area",
                        "enterTimeSchema %s; exitTimeSchema %s"
                            .formatted(
                                String.join(", ", wish.schemas().enter()),
                                String.join(", ", wish.schemas().exit())))));
  }

  private static String metadata(int choice, List<ChoiceValues> choices) {
    ChoiceValues values = choices.get(choice);
    return "version %d: %s, %s"
        .formatted(
            choice + 1,
            values.type().map(ConsistencyType::spelling).orElse("no type"),
            values.degree().map(Degree::spelling).orElse("no degree"));
  }

  private static String band(Band band) {
    return switch (band) {
      case NON_EXPECTANT -> "not expected, to 3";
      case NEUTRAL -> "neutral, 3 to 4";
      case EXPECTANT -> "expected, from 4";
    };
  }

  @Override
  protected Object cell(Row row, int column) {
    return row.cell(column);
  }
}
