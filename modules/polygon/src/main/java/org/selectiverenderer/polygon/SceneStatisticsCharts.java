package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.chart.BarChart;
import org.selectiverenderer.chart.BarChart.Bar;
import org.selectiverenderer.chart.ChartColour;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

/**
 * Makes the bar charts of a scene: two for each scope, of its objects (Figs 68, 70, 72) and of its
 * states (Figs 87, 88, 90).
 */
public final class SceneStatisticsCharts {
  /** The largest number of bars in a chart; the subtitle says how many more were left out. */
  static final int MAX_BARS = 200;

  private SceneStatisticsCharts() {}

  /** Returns the charts of a count. */
  public static List<BarChart> of(SceneStatistics statistics) {
    List<BarChart> charts = new ArrayList<>();
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
              "polygons shown, and percent of the polygons with all objects high",
              "",
              0,
              states(scope)));
    }
    return charts;
  }

  private static BarChart chart(
      String title, String subtitle, String unit, double least, List<Bar> bars) {
    int more = bars.size() - MAX_BARS;
    return more <= 0
        ? new BarChart(title, subtitle, unit, least, bars)
        : new BarChart(
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
        bars.add(new Bar(label, object.percent(i), figure, ChartColour.BLUE));
      }
    }
  }

  private static List<Bar> states(ScopeCount scope) {
    List<Bar> bars = new ArrayList<>();
    bars.add(bar("all objects high", scope.high(), 100, scope.high(), ChartColour.GREY));
    for (int i = 0; i < scope.states().size(); i++) {
      StateCount state = scope.states().get(i);
      ChartColour colour =
          i == 0
              ? ChartColour.BLUE
              : state.schemas().size() > 1 ? ChartColour.VERMILION : ChartColour.ORANGE;
      bars.add(
          bar(
              SceneStatisticsTextWriter.label(state),
              state.polygons(),
              state.percent(),
              scope.high(),
              colour));
    }
    return bars;
  }

  private static Bar bar(
      String label, long polygons, double percent, long high, ChartColour colour) {
    String figure =
        high == 0
            ? DecimalFormatter.grouped(polygons)
            : String.format(Locale.ROOT, "%,d  (%.1f %%)", polygons, percent);
    return new Bar(label, polygons, figure, colour);
  }
}
