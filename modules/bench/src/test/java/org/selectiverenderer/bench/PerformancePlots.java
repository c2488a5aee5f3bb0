package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.bench.PerformancePlot.Form;
import org.selectiverenderer.chart.BarPlot;
import org.selectiverenderer.chart.BarPlot.Group;
import org.selectiverenderer.chart.LinePlot;
import org.selectiverenderer.chart.LinePlot.Curve;
import org.selectiverenderer.chart.LinePlot.Point;
import org.selectiverenderer.chart.Plot;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvNumberParser;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;

/**
 * Draws the plots of docs/performance.md from the measured figures beside it.
 *
 * <p>Figures are CSV files, one of a plot's name for each {@link PerformancePlot} that has been
 * measured. Bars have the columns {@code group,series,value}: a group is a scene, a series a
 * program or, of bars with parts, a step. Curves have {@code series,x,y}. Groups, series and points
 * come in the order of the file; the first series is this program.
 */
final class PerformancePlots {
  private final Path folder;

  /**
   * @param folder of the figures; need not exist
   */
  PerformancePlots(Path folder) {
    this.folder = folder;
  }

  /**
   * The SVG files, by name.
   *
   * @throws IOException if a file of figures cannot be read, or is wrong; says where
   */
  Map<String, String> files() throws IOException {
    Map<String, String> files = new LinkedHashMap<>();
    for (PerformancePlot plot : PerformancePlot.values()) {
      Path figures = folder.resolve(plot.fileName() + ".csv");
      if (Files.exists(figures)) {
        files.put("performance-" + plot.fileName() + ".svg", plot(plot, figures).svg());
      }
    }
    return files;
  }

  private static Plot plot(PerformancePlot plot, Path figures) throws IOException {
    return plot.form() == Form.CURVES ? curves(plot, figures) : bars(plot, figures);
  }

  private static BarPlot bars(PerformancePlot plot, Path figures) throws IOException {
    Set<String> series = new LinkedHashSet<>();
    Map<String, Map<String, Double>> groups = new LinkedHashMap<>();
    List<String> faults = new ArrayList<>();
    CsvErrorHandler hears = (at, message) -> faults.add(at + ": " + message);
    for (CsvRow row : rows(figures, List.of("group", "series", "value"), hears)) {
      series.add(row.cell("series"));
      Map<String, Double> values =
          groups.computeIfAbsent(row.cell("group"), name -> new LinkedHashMap<>());
      CsvNumberParser.number(row, "value", hears)
          .ifPresent(
              value -> {
                if (values.put(row.cell("series"), value) != null) {
                  hears.fault(row.location(), "this bar is there already");
                }
              });
    }
    refuse(faults);
    return new BarPlot(
        plot.title(),
        plot.subtitle(),
        plot.unit(0),
        plot.form() == Form.PARTS,
        List.copyOf(series),
        groups.entrySet().stream().map(g -> new Group(g.getKey(), g.getValue())).toList());
  }

  private static LinePlot curves(PerformancePlot plot, Path figures) throws IOException {
    Map<String, List<Point>> curves = new LinkedHashMap<>();
    List<String> faults = new ArrayList<>();
    CsvErrorHandler hears = (at, message) -> faults.add(at + ": " + message);
    for (CsvRow row : rows(figures, List.of("series", "x", "y"), hears)) {
      double x = CsvNumberParser.number(row, "x", hears).orElse(1);
      double y = CsvNumberParser.number(row, "y", hears).orElse(1);
      curves.computeIfAbsent(row.cell("series"), name -> new ArrayList<>()).add(new Point(x, y));
    }
    refuse(faults);
    return new LinePlot(
        plot.title(),
        plot.subtitle(),
        plot.unit(0),
        plot.unit(1),
        curves.entrySet().stream().map(c -> new Curve(c.getKey(), c.getValue())).toList());
  }

  private static List<CsvRow> rows(Path figures, List<String> columns, CsvErrorHandler hears)
      throws IOException {
    CsvTable table = CsvTable.read(figures, CsvColumnSpec.of(columns), hears).orElse(null);
    return table != null && table.require(columns, "a plot needs") ? table.rows() : List.of();
  }

  private static void refuse(List<String> faults) throws IOException {
    if (!faults.isEmpty()) {
      throw new IOException(String.join("; ", faults));
    }
  }
}
