package org.selectiverenderer.study.dataset;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A column of a {@link DataTable} with its documentation.
 *
 * @param name letters, digits and underscores, so that R and pandas accept it as a name
 * @param unit unit of a number, in the spelling of BIDS; empty for none
 * @param levels the possible values with their meanings; empty for a column without fixed values
 * @param meaning what a cell means, one sentence without a full stop
 */
public record TableColumn(
    String name, Type type, String unit, Map<String, String> levels, String meaning) {

  /** The data type of the cells. */
  public enum Type {
    TEXT("text"),
    WHOLE("whole number"),
    NUMBER("number"),
    /** A date and time by ISO 8601, with an offset from UTC or a Z. */
    TIME("date and time"),
    /** One of the levels. */
    CATEGORY("category");

    private final String spelling;

    Type(String spelling) {
      this.spelling = spelling;
    }

    /** Returns the type's name in the codebook. */
    public String spelling() {
      return spelling;
    }
  }

  public TableColumn {
    levels = Collections.unmodifiableMap(new LinkedHashMap<>(levels));
  }

  /** Returns a column of texts. */
  public static TableColumn text(String name, String meaning) {
    return new TableColumn(name, Type.TEXT, "", Map.of(), meaning);
  }

  /** Returns a column of counts: whole numbers without a unit. */
  public static TableColumn whole(String name, String meaning) {
    return new TableColumn(name, Type.WHOLE, "", Map.of(), meaning);
  }

  /**
   * Returns a column of numbers.
   *
   * @param unit as BIDS spells it; empty for none
   */
  public static TableColumn number(String name, String unit, String meaning) {
    return new TableColumn(name, Type.NUMBER, unit, Map.of(), meaning);
  }

  /** Returns a column of dates with times. */
  public static TableColumn time(String name, String meaning) {
    return new TableColumn(name, Type.TIME, "", Map.of(), meaning);
  }

  /** Returns a column of categories, in the order of the levels. */
  public static TableColumn category(String name, Map<String, String> levels, String meaning) {
    return new TableColumn(name, Type.CATEGORY, "", levels, meaning);
  }

  /** Returns a column of {@code yes} and {@code no}. */
  public static TableColumn yesNo(String name, String yes, String no, String meaning) {
    Map<String, String> levels = new LinkedHashMap<>();
    levels.put("yes", yes);
    levels.put("no", no);
    return category(name, levels, meaning);
  }
}
