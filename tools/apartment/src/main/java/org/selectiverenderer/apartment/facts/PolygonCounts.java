package org.selectiverenderer.apartment.facts;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.formats.csv.CsvRow;

/** The polygon counts of the objects with two versions (thesis Figs 67, 69 and 71). */
public final class PolygonCounts {
  private final Map<String, Counts> byObject = new LinkedHashMap<>();

  /**
   * @param area {@code kitchen}, {@code lounge} or {@code office}
   * @param original polygons of version 1
   * @param reduced polygons of version 2
   */
  public record Counts(String area, String object, int original, int reduced) {}

  private PolygonCounts() {}

  public static PolygonCounts load() {
    PolygonCounts counts = new PolygonCounts();
    for (CsvRow row : CsvResource.rows("polygon-counts.csv")) {
      String object = row.cell("object");
      counts.byObject.put(
          object,
          new Counts(
              row.cell("area"),
              object,
              Integer.parseInt(row.cell("polygons_v1")),
              Integer.parseInt(row.cell("polygons_v2"))));
    }
    return counts;
  }

  /** Returns the counts of an object; empty if it has one version. */
  public Optional<Counts> of(String object) {
    return Optional.ofNullable(byObject.get(object));
  }

  /** Returns the counts of all objects, in the order of the tables. */
  public Map<String, Counts> all() {
    return Collections.unmodifiableMap(byObject);
  }
}
