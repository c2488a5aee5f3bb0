package org.selectiverenderer.enricher.cost;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.CostKind;

/** The table model of the scene's parts in their states, with editable limits. */
final class StatesTableModel extends RowTableModel<CostRow> {
  static final int SCOPE = 0;
  static final int STATE = 1;
  static final int POLYGONS = 2;
  static final int PERCENT = 3;
  static final int TEXTURES = 4;
  static final int DRAWS = 5;
  static final int LIMIT = 6;
  static final int BAR = 7;
  private static final long serialVersionUID = 1L;

  /** Most digits of a limit. */
  private static final int DIGITS = 15;

  private final transient BiConsumer<CostRow, Optional<Long>> limits;

  /**
   * @param limits called with the limit that the author sets; empty for no limit
   */
  StatesTableModel(BiConsumer<CostRow, Optional<Long>> limits) {
    super(
        Texts.of("cost.scope"),
        Texts.of("cost.state"),
        Texts.of("cost.polygons"),
        Texts.of("cost.percent"),
        Texts.of("cost.textures"),
        Texts.of("cost.draws"),
        Texts.of("cost.limit"),
        Texts.of("cost.bar"));
    this.limits = limits;
  }

  void rows(List<CostRow> rows) {
    update(rows);
  }

  @Override
  protected Object cell(CostRow row, int column) {
    return switch (column) {
      case SCOPE -> CostFormatter.scope(row);
      case STATE -> CostFormatter.state(row);
      case POLYGONS -> DecimalFormatter.grouped(row.polygons());
      case PERCENT -> CostFormatter.percent(row);
      case TEXTURES -> CostFormatter.textures(row);
      case DRAWS -> CostFormatter.draws(row);
      case LIMIT -> limit(row).map(DecimalFormatter::grouped).orElse("");
      default -> row;
    };
  }

  private static Optional<Long> limit(CostRow row) {
    return row.limit().flatMap(budget -> budget.limit(CostKind.POLYGONS));
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == LIMIT && row(row).limitable();
  }

  /** Parses a number with or without group separators; empty if it is none. */
  static Optional<Long> number(String text) {
    String digits = text.strip().replaceAll("[\\s,.'\u2019\u00a0\u202f]", "");
    return digits.matches("[0-9]{1," + DIGITS + "}")
        ? Optional.of(Long.parseLong(digits))
        : Optional.empty();
  }

  /** Sets a limit; an empty text removes it. */
  @Override
  public void setValueAt(Object value, int row, int column) {
    String text = String.valueOf(value);
    Optional<Long> number = number(text);
    boolean other = !number.equals(limit(row(row)));
    if (other && (number.isPresent() || text.isBlank())) {
      limits.accept(row(row), number);
    }
  }
}
