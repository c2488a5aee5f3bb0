package org.selectiverenderer.document.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.document.CsvRows;
import org.selectiverenderer.document.CsvRows.Row;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.x3d.Problems;

/**
 * How likely people find it that an object is in the place of a schema.
 *
 * @param means by object and schema, in the order of the table
 */
public record Ratings(Map<String, Map<String, Mean>> means) {
  private static final List<String> COLUMNS = List.of("object", "schema", "rating");

  /**
   * The mean of all ratings of one object in one place.
   *
   * @param value from 1, unlikely, to 6, likely
   * @param count of the ratings
   */
  public record Mean(double value, int count) {
    public Band band() {
      return Band.of(value);
    }
  }

  /**
   * Reads a table with the columns {@code object,schema,rating}, one or many rows for a pair.
   *
   * @param name of its file, for messages
   * @return empty if it is no such table or a rating is none from 1 to 6, which is reported; a row
   *     without a rating is one that nobody gave
   */
  public static Optional<Ratings> read(String name, byte[] table, Problems problems) {
    Optional<List<Row>> rows = CsvRows.read(name, table, COLUMNS, problems);
    if (rows.isEmpty()) {
      return Optional.empty();
    }
    Map<String, Map<String, List<Double>>> all = new LinkedHashMap<>();
    boolean faulty = false;
    for (Row row : rows.get()) {
      String object = row.cell("object");
      String schema = row.cell("schema");
      if (row.cell("rating").isEmpty()) {
        continue;
      }
      Optional<Double> rating = rating(row.cell("rating"));
      if (object.isEmpty() || schema.isEmpty() || rating.isEmpty()) {
        faulty = true;
        problems.error(
            row.at(),
            rating.isEmpty()
                ? "'%s' is no rating from 1 to 6; the table is not used"
                    .formatted(row.cell("rating"))
                : "a rating needs an object and a schema; the table is not used");
        continue;
      }
      all.computeIfAbsent(object, key -> new LinkedHashMap<>())
          .computeIfAbsent(schema, key -> new ArrayList<>())
          .add(rating.get());
    }
    return faulty ? Optional.empty() : Optional.of(new Ratings(means(all)));
  }

  private static Optional<Double> rating(String text) {
    try {
      double rating = Double.parseDouble(text.replace(',', '.'));
      return rating >= 1 && rating <= 6 ? Optional.of(rating) : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  private static Map<String, Map<String, Mean>> means(
      Map<String, Map<String, List<Double>>> ratings) {
    Map<String, Map<String, Mean>> means = new LinkedHashMap<>();
    ratings.forEach(
        (object, bySchema) -> {
          Map<String, Mean> ofObject = new LinkedHashMap<>();
          bySchema.forEach(
              (schema, values) ->
                  ofObject.put(
                      schema,
                      new Mean(
                          values.stream().mapToDouble(v -> v).average().orElseThrow(),
                          values.size())));
          means.put(object, ofObject);
        });
    return means;
  }
}
