package org.selectiverenderer.polygon.statistics;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;
import org.selectiverenderer.polygon.statistics.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.statistics.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.statistics.SceneStatistics.StateCount;

/**
 * Polygon counts as CSV with the header {@code kind,scope,name,version,polygons,percent}, one row
 * for each
 *
 * <ul>
 *   <li>{@code total}: the scene, its name the file's;
 *   <li>{@code object}: a version of an object, numbered from 1, in percent of the original;
 *   <li>{@code high}: a scope with all objects high;
 *   <li>{@code state}: a scope with schemas activated, its name the schemas, {@code +} between
 *       them.
 * </ul>
 */
public final class StatisticsCsv {
  private StatisticsCsv() {}

  /** Lines that end with LF. */
  public static String of(SceneStatistics statistics) {
    StringBuilder text = new StringBuilder();
    CSVFormat format = CSVFormat.RFC4180.builder().setRecordSeparator("\n").get();
    try (CSVPrinter csv = new CSVPrinter(text, format)) {
      csv.printRecord("kind", "scope", "name", "version", "polygons", "percent");
      csv.printRecord("total", "", statistics.scene(), "", statistics.totalHigh(), "100.00");
      for (ObjectCount object : statistics.objects()) {
        print(csv, object);
      }
      for (ScopeCount scope : statistics.scopes()) {
        csv.printRecord("high", scope.scope(), "", "", scope.high(), "100.00");
        for (StateCount state : scope.states()) {
          String name = String.join("+", state.schemas());
          csv.printRecord(
              "state", scope.scope(), name, "", state.polygons(), percent(state.percent()));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e); // a StringBuilder does not fail
    }
    return text.toString();
  }

  private static void print(CSVPrinter csv, ObjectCount object) throws IOException {
    List<Long> versions = object.versions();
    for (int i = 0; i < versions.size(); i++) {
      csv.printRecord(
          "object",
          object.scope().orElse(""),
          object.switchName(),
          i + 1,
          versions.get(i),
          percent(object.percent(i)));
    }
  }

  private static String percent(double value) {
    return String.format(Locale.ROOT, "%.2f", value);
  }
}
