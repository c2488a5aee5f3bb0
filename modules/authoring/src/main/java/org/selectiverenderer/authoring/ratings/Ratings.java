package org.selectiverenderer.authoring.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.authoring.enrichment.SchemaNameValidator;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvNumberParser;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.schema.RatingBand;
import org.selectiverenderer.x3d.source.DecodedText;

/**
 * Expectancy ratings: how likely people find it that an object is in the place of a schema.
 *
 * @param means mean ratings by object and schema, in the order of the table
 */
public record Ratings(Map<String, Map<String, Mean>> means) {
  private static final List<String> COLUMNS = List.of("object", "schema", "rating");
  private static final CsvColumnSpec FORM = new CsvColumnSpec(COLUMNS, true, true);

  /**
   * The mean of all ratings of one object in one place.
   *
   * @param value from 1, unlikely, to 6, likely
   * @param count number of ratings
   */
  public record Mean(double value, int count) {
    public RatingBand band() {
      return RatingBand.of(value);
    }
  }

  /**
   * Reads a table with the columns {@code object,schema,rating}, one or many rows for a pair.
   *
   * @param name name of the file, for messages
   * @return empty if it is not such a table or a rating is not from 1 to 6, which is reported; rows
   *     without a rating are skipped
   */
  public static Optional<Ratings> read(String name, byte[] table, ProblemCollector problems) {
    ProblemCollector own = new ProblemCollector(problems::add);
    CsvErrorHandler faults = (at, message) -> own.error(at, message + "; the table is not used");
    Optional<CsvTable> read =
        CsvTable.parse(name, DecodedText.of(table).characters(), FORM, faults);
    if (read.isEmpty() || !read.get().require(COLUMNS, String.join(",", COLUMNS))) {
      return Optional.empty();
    }
    Map<String, Map<String, List<Double>>> all = new LinkedHashMap<>();
    for (CsvRow row : read.get().rows()) {
      String object = row.cell("object");
      String schema = row.cell("schema");
      if (row.cell("rating").isEmpty()) {
        continue;
      }
      OptionalDouble rating = CsvNumberParser.number(row, "rating", faults);
      if (rating.isEmpty()) {
        continue;
      }
      if (rating.getAsDouble() < 1 || rating.getAsDouble() > 6) {
        faults.fault(
            row.location("rating"),
            CsvNumberParser.quoted(row.cell("rating")) + " is not a rating from 1 to 6");
      } else if (object.isEmpty() || schema.isEmpty()) {
        faults.fault(row.location(), "a rating needs an object and a schema");
      }
      SchemaNameValidator.complaint(schema)
          .ifPresent(why -> faults.fault(row.location("schema"), why));
      all.computeIfAbsent(object, key -> new LinkedHashMap<>())
          .computeIfAbsent(schema, key -> new ArrayList<>())
          .add(rating.getAsDouble());
    }
    return own.any() ? Optional.empty() : Optional.of(new Ratings(means(all)));
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
