package org.selectiverenderer.enricher.cost;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.budget.BudgetStatus;

/** Formats rows of the cost table as text. */
final class CostFormatter {
  private CostFormatter() {}

  static String scope(CostRow row) {
    return row.scope().isEmpty() ? Texts.of("cost.whole") : row.scope();
  }

  static String state(CostRow row) {
    String names = names(row.schemas());
    return switch (row.kind()) {
      case ALL -> Texts.of("cost.all");
      case LOADED -> names.isEmpty() ? Texts.of("cost.loaded") : Texts.of("cost.loadedin", names);
      case STATE -> names.isEmpty() ? Texts.of("cost.outside") : names;
      case WORST -> Texts.of("cost.worst");
    };
  }

  private static String names(List<String> schemas) {
    return String.join(", ", schemas);
  }

  static String percent(CostRow row) {
    return row.percent() < 0 ? "" : DecimalFormatter.fixed(row.percent(), 1) + " %";
  }

  /** How many polygons are left or too many against the limit; empty where there is none. */
  static Optional<String> verdict(CostRow row) {
    return row.status()
        .map(
            status ->
                status.broken()
                    ? Texts.of("cost.over", DecimalFormatter.grouped(status.over()))
                    : Texts.of(
                        "cost.left",
                        DecimalFormatter.grouped(
                            status.budget().polygons() - status.worst().polygons())));
  }

  /** The status bar's sentence about a limit that is exceeded now. */
  static String warning(CostRow row, BudgetStatus status) {
    return Texts.of(
        "cost.broken",
        scope(row),
        state(row),
        DecimalFormatter.grouped(status.worst().polygons()),
        DecimalFormatter.grouped(status.over()),
        DecimalFormatter.grouped(status.budget().polygons()));
  }
}
