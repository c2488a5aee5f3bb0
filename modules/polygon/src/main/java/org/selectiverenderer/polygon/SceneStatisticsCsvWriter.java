package org.selectiverenderer.polygon;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

/**
 * Writes polygon counts as CSV with the header {@code
 * kind,scope,name,version,polygons,percent,draw_calls,texture_bytes}, one row for each
 *
 * <ul>
 *   <li>{@code total}: the scene, named by its file;
 *   <li>{@code object}: a version of an object, numbered from 1, in percent of the original;
 *   <li>{@code high}: a scope with all objects high;
 *   <li>{@code state}: a scope with schemas activated, named by the schemas with {@code +} between
 *       them.
 * </ul>
 */
public final class SceneStatisticsCsvWriter {
  private static final Object[] HEADER = {
    "kind", "scope", "name", "version", "polygons", "percent", "draw_calls", "texture_bytes"
  };

  private SceneStatisticsCsvWriter() {}

  /** Returns the CSV text, whose lines end with LF. */
  public static String of(SceneStatistics statistics) {
    CsvWriter csv = new CsvWriter();
    csv.row(HEADER);
    rows(statistics, csv::row);
    return csv.toString();
  }

  /**
   * Returns the header of a table of many scenes: a column {@code scene}, then the columns of one
   * scene.
   */
  public static String headerOfMany() {
    CsvWriter csv = new CsvWriter();
    csv.row(withScene("scene", HEADER));
    return csv.toString();
  }

  /** Returns the rows of one scene in a table of many. */
  public static String rowsOfMany(SceneStatistics statistics) {
    CsvWriter csv = new CsvWriter();
    rows(statistics, cells -> csv.row(withScene(statistics.scene(), cells)));
    return csv.toString();
  }

  private static Object[] withScene(String scene, Object[] cells) {
    return Stream.concat(Stream.of(scene), Stream.of(cells)).toArray();
  }

  /** Receives the cells of a row. */
  private interface Rows {
    void row(Object... cells);
  }

  private static void rows(SceneStatistics statistics, Rows csv) {
    csv.row("total", "", statistics.scene(), "", statistics.totalHigh(), "100.00", "", "");
    for (ObjectCount object : statistics.objects()) {
      print(csv, object);
    }
    for (ScopeCount scope : statistics.scopes()) {
      csv.row(
          "high",
          scope.scope(),
          "",
          "",
          scope.high(),
          "100.00",
          scope.highCost().drawCalls(),
          scope.highCost().textureBytes());
      for (StateCount state : scope.states()) {
        String name = String.join("+", state.schemas());
        csv.row(
            "state",
            scope.scope(),
            name,
            "",
            state.polygons(),
            percent(state.percent()),
            state.cost().drawCalls(),
            state.cost().textureBytes());
      }
    }
  }

  private static void print(Rows csv, ObjectCount object) {
    List<Long> versions = object.versions();
    for (int i = 0; i < versions.size(); i++) {
      csv.row(
          "object",
          object.scope().orElse(""),
          object.switchName(),
          i + 1,
          versions.get(i),
          percent(object.percent(i)),
          "",
          "");
    }
  }

  private static String percent(double value) {
    return String.format(Locale.ROOT, "%.2f", value);
  }
}
