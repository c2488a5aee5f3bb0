package org.selectiverenderer.enricher.cost;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.images.ByteFormat;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.CostKind;
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

  /** The bytes of textures, with a sign where they are more than their limit. */
  static String textures(CostRow row) {
    return marked(row, CostKind.TEXTURE_BYTES, ByteFormat.of(row.cost().textureBytes()));
  }

  /** The number of draw calls, with a sign where they are more than their limit. */
  static String draws(CostRow row) {
    return marked(row, CostKind.DRAW_CALLS, DecimalFormatter.grouped(row.cost().drawCalls()));
  }

  private static String marked(CostRow row, CostKind kind, String text) {
    boolean broken = row.status(kind).filter(BudgetStatus::broken).isPresent();
    return broken ? "\u25b2 " + text : text;
  }

  /** What a column counts, and its limit where it has one. */
  static String costTip(CostRow row, CostKind kind) {
    boolean bytes = kind == CostKind.TEXTURE_BYTES;
    return Texts.of(bytes ? "cost.textures.tip" : "cost.draws.tip")
        + row.status(kind)
            .map(
                status ->
                    " "
                        + Texts.of(
                            "cost.limitof",
                            bytes
                                ? ByteFormat.of(status.limit())
                                : DecimalFormatter.grouped(status.limit())))
            .orElse("");
  }

  /** How many polygons are left or too many against the limit; empty where there is none. */
  static Optional<String> verdict(CostRow row) {
    return row.status()
        .map(
            status ->
                status.broken()
                    ? Texts.of("cost.over", DecimalFormatter.grouped(status.over()))
                    : Texts.of(
                        "cost.left", DecimalFormatter.grouped(status.limit() - status.cost())));
  }

  /** The status bar's sentence about a limit that is exceeded now. */
  static String warning(CostRow row, BudgetStatus status) {
    return Texts.of(
        "cost.broken",
        scope(row),
        state(row),
        DecimalFormatter.grouped(status.cost()),
        DecimalFormatter.grouped(status.over()),
        DecimalFormatter.grouped(status.limit()));
  }
}
