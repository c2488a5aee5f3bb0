package org.selectiverenderer.enricher.cost;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;

/** Parts of the scene in their states, with limits that can be written. */
final class StatesModel extends RowTableModel<CostRow> {
  static final int SCOPE = 0;
  static final int STATE = 1;
  static final int POLYGONS = 2;
  static final int PERCENT = 3;
  static final int LIMIT = 4;
  static final int BAR = 5;
  private static final long serialVersionUID = 1L;

  /** More digits than any scene has polygons. */
  private static final int DIGITS = 15;

  private final transient BiConsumer<CostRow, Optional<Long>> limits;

  /**
   * @param limits hears what the author writes; empty for no limit
   */
  StatesModel(BiConsumer<CostRow, Optional<Long>> limits) {
    super(
        Texts.of("cost.scope"),
        Texts.of("cost.state"),
        Texts.of("cost.polygons"),
        Texts.of("cost.percent"),
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
      case SCOPE -> CostWords.scope(row);
      case STATE -> CostWords.state(row);
      case POLYGONS -> DecimalText.grouped(row.polygons());
      case PERCENT -> CostWords.percent(row);
      case LIMIT -> row.limit().map(limit -> DecimalText.grouped(limit.polygons())).orElse("");
      default -> row;
    };
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == LIMIT && row(row).limitable();
  }

  /** The number that an author means: digits, in groups or not; empty if it is none. */
  static Optional<Long> number(String text) {
    String digits = text.strip().replaceAll("[\\s,.'\u2019\u00a0\u202f]", "");
    return digits.matches("[0-9]{1," + DIGITS + "}")
        ? Optional.of(Long.parseLong(digits))
        : Optional.empty();
  }

  /** Takes a number, or nothing for no limit. */
  @Override
  public void setValueAt(Object value, int row, int column) {
    String text = String.valueOf(value);
    Optional<Long> number = number(text);
    boolean other = !number.equals(row(row).limit().map(limit -> limit.polygons()));
    if (other && (number.isPresent() || text.isBlank())) {
      limits.accept(row(row), number);
    }
  }
}
