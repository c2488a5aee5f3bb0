package org.selectiverenderer.polygon.count;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;

/** The thesis's figures: Figs 67, 69, 71, and Tables 3-5 as printed and as they add up. */
public final class ThesisPolygonCounts {
  private ThesisPolygonCounts() {}

  /**
   * An object of Figs 67, 69, 71.
   *
   * @param revolves the part of the room that makes it inconsistent, or empty
   */
  public record ThesisObject(String area, String object, int v1, int v2, String revolves) {}

  /**
   * A row of Tables 3-5.
   *
   * @param state as the table calls it
   * @param note why the printed number differs
   */
  public record Total(String area, String state, long printed, long recomputed, String note) {
    /** Whether the printed number is not the sum of the listed ones. */
    public boolean misprint() {
      return printed != recomputed;
    }
  }

  public static List<ThesisObject> objects() {
    return rows("polygon-counts.csv").stream()
        .map(
            row ->
                new ThesisObject(
                    row.get("area"),
                    row.get("object"),
                    Integer.parseInt(row.get("polygons_v1")),
                    Integer.parseInt(row.get("polygons_v2")),
                    row.get("revolves_in")))
        .toList();
  }

  public static List<Total> totals() {
    return rows("polygon-totals.csv").stream()
        .map(
            row ->
                new Total(
                    row.get("area"),
                    row.get("state"),
                    Long.parseLong(row.get("printed")),
                    Long.parseLong(row.get("recomputed")),
                    row.get("note")))
        .toList();
  }

  private static List<CSVRecord> rows(String resource) {
    try (Reader in =
        new InputStreamReader(
            Objects.requireNonNull(ThesisPolygonCounts.class.getResourceAsStream(resource)),
            StandardCharsets.UTF_8)) {
      return CSVFormat.DEFAULT
          .builder()
          .setHeader()
          .setSkipHeaderRecord(true)
          .get()
          .parse(in)
          .getRecords();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
