package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

/** Writes polygon counts as text: two tables for each scope, as in Figs 67-71 and Tables 3-5. */
public final class SceneStatisticsTextWriter {
  private SceneStatisticsTextWriter() {}

  /** Returns the text; its last line is terminated. */
  public static String of(SceneStatistics statistics) {
    StringBuilder text = new StringBuilder();
    text.append(ControlCharacterEscaper.line(statistics.scene()))
        .append(": ")
        .append(DecimalFormatter.grouped(statistics.totalHigh()))
        .append(
            statistics.objects().isEmpty()
                ? " polygons; no object is enriched\n"
                : " polygons with all objects high\n");
    for (ScopeCount scope : statistics.scopes()) {
      text.append('\n').append(ControlCharacterEscaper.line(scope.scope())).append("\n\n");
      List<ObjectCount> objects = statistics.objectsOf(scope);
      if (!objects.isEmpty()) {
        table(text, objects(objects)).append('\n');
      }
      table(text, states(scope, !statistics.objects().isEmpty()));
    }
    List<ObjectCount> outside =
        statistics.objects().stream().filter(object -> object.scope().isEmpty()).toList();
    if (!outside.isEmpty()) {
      text.append("\nin no scope\n\n");
      table(text, objects(outside));
    }
    return text.toString();
  }

  private static List<List<String>> objects(List<ObjectCount> objects) {
    int versions = objects.stream().mapToInt(object -> object.versions().size()).max().orElse(0);
    List<List<String>> rows = new ArrayList<>();
    List<String> head = new ArrayList<>(List.of("object"));
    for (int i = 1; i <= versions; i++) {
      head.add("v" + i);
      head.add("");
    }
    rows.add(head);
    for (ObjectCount object : objects) {
      List<String> row =
          new ArrayList<>(List.of(ControlCharacterEscaper.line(object.switchName())));
      for (int i = 0; i < object.versions().size(); i++) {
        row.add(DecimalFormatter.grouped(object.versions().get(i)));
        row.add(
            i == object.original()
                ? ""
                : percent(object.percent(i), object.versions().get(object.original())));
      }
      rows.add(row);
    }
    return rows;
  }

  private static List<List<String>> states(ScopeCount scope, boolean enriched) {
    List<List<String>> rows = new ArrayList<>();
    rows.add(List.of("activated", "polygons", ""));
    if (enriched) {
      rows.add(
          List.of(
              "all objects high",
              DecimalFormatter.grouped(scope.high()),
              percent(100, scope.high())));
    }
    for (StateCount state : scope.states()) {
      rows.add(
          List.of(
              ControlCharacterEscaper.line(label(state)),
              DecimalFormatter.grouped(state.polygons()),
              percent(state.percent(), scope.high())));
    }
    return rows;
  }

  /** Returns the schemas of a state in words. */
  public static String label(StateCount state) {
    return state.schemas().isEmpty() ? "as loaded" : String.join(" and ", state.schemas());
  }

  private static String percent(double percent, long of) {
    return of == 0 ? "-" : String.format(Locale.ROOT, "%.2f %%", percent);
  }

  /**
   * Appends a table with columns of minimal width; the first one is aligned left, numbers are
   * aligned right.
   */
  private static StringBuilder table(StringBuilder text, List<List<String>> rows) {
    int[] widths = new int[rows.stream().mapToInt(List::size).max().orElse(0)];
    for (List<String> row : rows) {
      for (int i = 0; i < row.size(); i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder("  ");
      for (int i = 0; i < row.size(); i++) {
        if (widths[i] == 0) {
          continue; // no gap for a column that is empty
        }
        String pad = " ".repeat(widths[i] - row.get(i).length());
        line.append(i == 0 ? row.get(i) + pad : "  " + pad + row.get(i));
      }
      text.append(line.toString().stripTrailing()).append('\n');
    }
    return text;
  }
}
