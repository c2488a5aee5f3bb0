package org.selectiverenderer.enricher.ratings;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.ratings.RatingPlan;
import org.selectiverenderer.authoring.ratings.RatingPlan.ImpliedSchema;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * The table model of what the ratings imply: their means, the bands of thesis 5.1, and the
 * resulting metadata.
 */
@SuppressWarnings("serial") // never written
final class ImpliedMetadataTableModel extends RowTableModel<ImpliedMetadataTableModel.Row> {
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

  private final RatingsImportModel model;

  ImpliedMetadataTableModel(RatingsImportModel model) {
    super(
        "Switch",
        Texts.of("ratings.schema"),
        Texts.of("ratings.mean"),
        Texts.of("ratings.count"),
        Texts.of("ratings.band"),
        Texts.of("ratings.metadata"));
    this.model = model;
    model.addListener(this::refresh);
    refresh();
  }

  private void refresh() {
    List<Row> fresh = new ArrayList<>();
    model.plan().ifPresent(plan -> add(plan, fresh));
    update(fresh);
  }

  private void add(RatingPlan plan, List<Row> rows) {
    for (RatingPlan.Row row : plan.rows()) {
      String name = row.node().name();
      for (ImpliedSchema implied : row.schemas()) {
        boolean gaze = model.gaze().told(name, implied.schema());
        rows.add(
            new Row(
                name,
                implied.schema(),
                gaze ? "" : DecimalFormatter.fixed(implied.mean().value(), 2),
                gaze ? "" : DecimalFormatter.grouped(implied.mean().count()),
                gaze ? Texts.of("ratings.fromgaze") : band(implied.mean()),
                implied
                    .choice()
                    .map(choice -> metadata(choice, row.choices()))
                    .orElse(Texts.of("ratings.asroom"))));
      }
      if (row.object().isEmpty()) {
        int last = row.choices().size() - 1;
        rows.add(
            new Row(
                name,
                String.join(", ", row.choices().get(last).schemas()),
                "",
                "0",
                Texts.of("ratings.notrated"),
                Texts.of("ratings.expectedroom", metadata(last, row.choices()))));
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
                        Texts.of("ratings.area"),
                        "enterTimeSchema %s; exitTimeSchema %s"
                            .formatted(
                                String.join(", ", wish.schemas().enter()),
                                String.join(", ", wish.schemas().exit())))));
  }

  private static String metadata(int choice, List<ChoiceMetadata> choices) {
    ChoiceMetadata values = choices.get(choice);
    return Texts.of(
        "ratings.version",
        DecimalFormatter.grouped(choice + 1),
        values.type().map(ConsistencyType::spelling).orElseGet(() -> Texts.of("ratings.notype")),
        values
            .degree()
            .map(ConsistencyDegree::spelling)
            .orElseGet(() -> Texts.of("ratings.nodegree")));
  }

  private String band(Ratings.Mean mean) {
    if (model.scale() == RatingScale.LINEAR) {
      return Texts.of(
          "ratings.scaled", DecimalFormatter.fixed(RatingScale.degree(mean.value()), 2));
    }
    return switch (mean.band()) {
      case NON_EXPECTANT -> Texts.of("ratings.unexpected");
      case NEUTRAL -> Texts.of("ratings.neutral");
      case EXPECTANT -> Texts.of("ratings.expected");
    };
  }

  @Override
  protected Object cell(Row row, int column) {
    return row.cell(column);
  }
}
