package org.selectiverenderer.app.replication;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.formats.csv.CsvWriter;

/** Writes the findings of a replication as CSV, one row for each printed number. */
final class ReplicationTables {
  private ReplicationTables() {}

  /** Returns the tables by the names of their files. */
  static Map<String, String> of(ReplicationFindings findings) {
    Map<String, String> files = new LinkedHashMap<>();
    files.put("tables-3-5.csv", polygons(findings));
    files.put("tables-6-11.csv", scores(findings));
    files.put("figures-93-98.csv", kitchen(findings));
    files.put("effects.csv", effects(findings));
    return files;
  }

  private static String polygons(ReplicationFindings findings) {
    CsvWriter csv = new CsvWriter();
    csv.row("table", "area", "schemas", "printed", "sum_of_listed_objects", "counted", "note");
    for (ReplicationFindings.PolygonRow row : findings.polygons()) {
      csv.row(
          row.total().table(),
          row.total().area(),
          row.total().schemas().isEmpty() ? "all objects high" : row.total().schemas(),
          row.total().printed(),
          row.total().recomputed(),
          row.counted().isPresent() ? row.counted().getAsLong() : "",
          row.total().note());
    }
    return csv.toString();
  }

  private static String scores(ReplicationFindings findings) {
    CsvWriter csv = new CsvWriter();
    csv.row(
        "table",
        "area",
        "objects",
        "condition",
        "confidence",
        "measure",
        "printed_O",
        "printed_mean",
        "printed_sd",
        "simulated_O",
        "simulated_n",
        "simulated_mean",
        "simulated_sd",
        "difference_in_standard_errors");
    for (ReplicationFindings.ScoreMean row : findings.scores()) {
      csv.row(
          row.row().table(),
          row.row().area(),
          row.row().type().equals("neutral") ? "all" : row.row().type(),
          row.row().condition(),
          row.level().spelling(),
          row.measure().key(),
          row.row().objects(),
          number(2, row.printed()),
          number(2, row.printedSd()),
          row.present(),
          row.n(),
          number(4, row.mean()),
          number(4, row.sd()),
          Double.isFinite(row.distance()) ? number(2, row.distance()) : "");
    }
    return csv.toString();
  }

  private static String kitchen(ReplicationFindings findings) {
    CsvWriter csv = new CsvWriter();
    csv.row("figure", "measure", "effect", "statistic", "printed", "computed_from_printed_means");
    for (KitchenRecomputation.Row row : findings.kitchen()) {
      ThesisTables.KitchenFigure figure = row.figure();
      csv.row(
          figure.figure(),
          figure.measure(),
          figure.effect(),
          figure.statistic(),
          figure.printed(),
          row.computed());
    }
    return csv.toString();
  }

  private static String effects(ReplicationFindings findings) {
    CsvWriter csv = new CsvWriter();
    csv.row(
        "source",
        "area",
        "confidence",
        "measure",
        "effect",
        "df1",
        "df2",
        "printed_F",
        "p_of_printed_F",
        "simulated_df2",
        "simulated_F",
        "simulated_p");
    for (ReplicationFindings.EffectRow row : findings.effects()) {
      ThesisTables.PrintedEffect printed = row.printed();
      csv.row(
          printed.source(),
          printed.area(),
          printed.level().spelling(),
          printed.measure().key(),
          printed.effect(),
          printed.df1(),
          printed.df2(),
          number(3, printed.f()),
          number(4, row.printedP()),
          row.simulated().map(effect -> number(0, effect.df2())).orElse(""),
          row.simulated().map(effect -> number(3, effect.f())).orElse(""),
          row.simulated().map(effect -> number(4, effect.p())).orElse(""));
    }
    return csv.toString();
  }

  private static String number(int decimals, double value) {
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }
}
