package org.selectiverenderer.app.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.app.chart.Chart.Bar;
import org.selectiverenderer.chart.Colour;
import org.selectiverenderer.polygon.statistics.SceneStatistics;
import org.selectiverenderer.polygon.statistics.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.statistics.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.statistics.SceneStatistics.StateCount;
import org.selectiverenderer.polygon.statistics.StatisticsText;

/** The charts of a scene: two for each scope, of its objects and of its states. */
final class StatisticsCharts {
  /** Bars beyond which a chart is cut off, and says so. */
  static final int MAX_BARS = 200;

  private StatisticsCharts() {}

  static List<Chart> of(SceneStatistics statistics) {
    List<Chart> charts = new ArrayList<>();
    for (ScopeCount scope : statistics.scopes()) {
      List<Bar> objects = new ArrayList<>();
      statistics.objectsOf(scope).forEach(object -> add(object, objects));
      if (!objects.isEmpty()) {
        charts.add(
            chart(
                scope.scope() + ": polygons of reduced versions",
                "percent of the original version's polygons",
                " %",
                100,
                objects));
      }
      charts.add(
          chart(
              scope.scope() + ": polygons per activated schema",
              "polygons shown, and percent of those with all objects high",
              "",
              0,
              states(scope)));
    }
    return charts;
  }

  private static Chart chart(
      String title, String subtitle, String unit, double least, List<Bar> bars) {
    int more = bars.size() - MAX_BARS;
    return more <= 0
        ? new Chart(title, subtitle, unit, least, bars)
        : new Chart(
            title,
            subtitle + "; " + more + " more are left out",
            unit,
            least,
            bars.subList(0, MAX_BARS));
  }

  private static void add(ObjectCount object, List<Bar> bars) {
    long original = object.versions().get(object.original());
    for (int i = 0; i < object.versions().size(); i++) {
      if (i != object.original()) {
        String name = object.switchName().replaceFirst("^Switch_(?=.)", "");
        String label = object.versions().size() > 2 ? name + ", v" + (i + 1) : name;
        String figure =
            original == 0
                ? "no polygons in the original"
                : String.format(
                    Locale.ROOT,
                    "%.1f %%  (%,d of %,d)",
                    object.percent(i),
                    object.versions().get(i),
                    original);
        bars.add(new Bar(label, object.percent(i), figure, Colour.BLUE));
      }
    }
  }

  private static List<Bar> states(ScopeCount scope) {
    List<Bar> bars = new ArrayList<>();
    bars.add(bar("all objects high", scope.high(), 100, scope.high(), Colour.GREY));
    for (int i = 0; i < scope.states().size(); i++) {
      StateCount state = scope.states().get(i);
      Colour colour =
          i == 0 ? Colour.BLUE : state.schemas().size() > 1 ? Colour.VERMILION : Colour.ORANGE;
      bars.add(
          bar(
              StatisticsText.label(state),
              state.polygons(),
              state.percent(),
              scope.high(),
              colour));
    }
    return bars;
  }

  private static Bar bar(String label, long polygons, double percent, long high, Colour colour) {
    String figure =
        high == 0
            ? String.format(Locale.ROOT, "%,d", polygons)
            : String.format(Locale.ROOT, "%,d  (%.1f %%)", polygons, percent);
    return new Bar(label, polygons, figure, colour);
  }
}
