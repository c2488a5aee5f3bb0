package org.selectiverenderer.apartment.facts;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.csv.CsvRow;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * How likely people found it that an object is in a room, and in the part of it where it stands
 * (thesis Appendix B).
 */
public final class Expectancies {
  private final Map<String, Ratings> byObject = new HashMap<>();

  /**
   * Mean ratings, 1 unlikely to 6 likely.
   *
   * @param mainSchema of the room
   * @param subSchema of the part of the room where the object stands
   */
  public record Ratings(String mainSchema, double main, String subSchema, double sub) {

    /** Whether the object turns inconsistent in the part of the room: the thesis's "revolves". */
    public boolean revolves() {
      return Band.of(main).consistency() == ConsistencyType.CONSISTENT
          && Band.of(sub).consistency() == ConsistencyType.INCONSISTENT;
    }
  }

  private Expectancies() {}

  public static Expectancies load() {
    Expectancies expectancies = new Expectancies();
    for (CsvRow row : FactsTable.rows("expectancies.csv")) {
      expectancies.byObject.put(
          row.cell("object"),
          new Ratings(
              row.cell("main_schema"),
              Double.parseDouble(row.cell("main_rating")),
              row.cell("sub_schema"),
              Double.parseDouble(row.cell("sub_rating"))));
    }
    return expectancies;
  }

  /** Empty for objects that stand in no rated part of a room, or were not asked for there. */
  public Optional<Ratings> of(String object) {
    return Optional.ofNullable(byObject.get(object));
  }
}
