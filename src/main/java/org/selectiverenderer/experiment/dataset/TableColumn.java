package org.selectiverenderer.experiment.dataset;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A column of a {@link DataTable} and what it means.
 *
 * @param name letters, digits and underscores, as R and pandas take it for a name
 * @param unit of a number, in the spelling of BIDS; empty where there is none
 * @param levels the values that it can have and what each means; empty where there are too many
 * @param meaning one sentence without a full stop
 */
public record TableColumn(
    String name, Type type, String unit, Map<String, String> levels, String meaning) {

  /** What its cells are. */
  public enum Type {
    TEXT("text"),
    WHOLE("whole number"),
    NUMBER("number"),
    /** ISO 8601, with an offset from UTC or a Z. */
    TIME("date and time"),
    /** One of the levels. */
    CATEGORY("category");

    private final String spelling;

    Type(String spelling) {
      this.spelling = spelling;
    }

    /** In words, as the codebook has it. */
    public String spelling() {
      return spelling;
    }
  }

  public TableColumn {
    levels = Collections.unmodifiableMap(new LinkedHashMap<>(levels));
  }

  /** Of texts. */
  public static TableColumn text(String name, String meaning) {
    return new TableColumn(name, Type.TEXT, "", Map.of(), meaning);
  }

  /** Of whole numbers that are counted. */
  public static TableColumn whole(String name, String meaning) {
    return new TableColumn(name, Type.WHOLE, "", Map.of(), meaning);
  }

  /**
   * Of numbers.
   *
   * @param unit as BIDS spells it; empty for none
   */
  public static TableColumn number(String name, String unit, String meaning) {
    return new TableColumn(name, Type.NUMBER, unit, Map.of(), meaning);
  }

  /** Of dates with their time. */
  public static TableColumn time(String name, String meaning) {
    return new TableColumn(name, Type.TIME, "", Map.of(), meaning);
  }

  /** Of values out of a few, in their order. */
  public static TableColumn category(String name, Map<String, String> levels, String meaning) {
    return new TableColumn(name, Type.CATEGORY, "", levels, meaning);
  }

  /** Of {@code yes} and {@code no}. */
  public static TableColumn yesNo(String name, String yes, String no, String meaning) {
    Map<String, String> levels = new LinkedHashMap<>();
    levels.put("yes", yes);
    levels.put("no", no);
    return category(name, levels, meaning);
  }
}
