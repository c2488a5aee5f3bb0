package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.csv.SpreadsheetText;
import org.selectiverenderer.schema.RatingBand;

/** The mean ratings of objects with their bands, as CSV for people (thesis 5.1). */
public final class RatingBandTable {
  private record Rated(String area, String schema, String object) {}

  private final Map<Rated, List<Integer>> all = new LinkedHashMap<>();

  /** Adds a rating of an object. */
  public void add(String area, String schema, String object, int rating) {
    all.computeIfAbsent(new Rated(area, schema, object), key -> new ArrayList<>()).add(rating);
  }

  /** Returns the table with its header. */
  public String text() {
    CsvWriter table = CsvWriter.bare();
    table.row("area", "schema", "object", "mean", "count", "band", "consistency");
    all.entrySet().stream()
        .sorted(
            Comparator.comparing((Map.Entry<Rated, List<Integer>> entry) -> entry.getKey().area())
                .thenComparing(entry -> entry.getKey().object()))
        .forEach(
            entry -> {
              double mean =
                  entry.getValue().stream().mapToInt(Integer::intValue).average().orElseThrow();
              RatingBand band = RatingBand.of(mean);
              table.row(
                  SpreadsheetText.marked(entry.getKey().area()),
                  SpreadsheetText.marked(entry.getKey().schema()),
                  SpreadsheetText.marked(entry.getKey().object()),
                  String.format(Locale.ROOT, "%.6f", mean),
                  entry.getValue().size(),
                  band.name().toLowerCase(Locale.ROOT).replace('_', '-'),
                  band.consistency().name().toLowerCase(Locale.ROOT));
            });
    return table.toString();
  }
}
