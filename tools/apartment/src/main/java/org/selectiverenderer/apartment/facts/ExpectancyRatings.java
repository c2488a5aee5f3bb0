package org.selectiverenderer.apartment.facts;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.RatingBand;

/**
 * Expectancy ratings: how likely people rated an object to be in a room, and in the part of the
 * room where it stands (thesis Appendix B).
 */
public final class ExpectancyRatings {
  private final Map<String, Ratings> byObject = new HashMap<>();

  /**
   * Mean ratings, 1 unlikely to 6 likely.
   *
   * @param mainSchema schema of the room
   * @param subSchema schema of the part of the room where the object stands
   */
  public record Ratings(String mainSchema, double main, String subSchema, double sub) {

    /**
     * Returns whether the object is consistent with the room and inconsistent with the part of it:
     * the thesis's "revolves".
     */
    public boolean revolves() {
      return RatingBand.of(main).consistency() == ConsistencyType.CONSISTENT
          && RatingBand.of(sub).consistency() == ConsistencyType.INCONSISTENT;
    }
  }

  private ExpectancyRatings() {}

  public static ExpectancyRatings load() {
    ExpectancyRatings expectancies = new ExpectancyRatings();
    for (CsvRow row : CsvResource.rows("expectancies.csv")) {
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

  /**
   * Returns the ratings of an object; empty if it stands in no rated part of a room, or was not
   * rated there.
   */
  public Optional<Ratings> of(String object) {
    return Optional.ofNullable(byObject.get(object));
  }
}
