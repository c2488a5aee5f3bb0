package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.chart.ChartFileWriter;
import org.selectiverenderer.chart.StepChart;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.formats.csv.CsvWriter;
import picocli.CommandLine.Option;

/** The options for the polygons over a walk, as a curve and as a table. */
final class PolygonCurveOptions {
  @Option(
      names = "--chart",
      paramLabel = "F.svg|F.png",
      description = "draws the polygons over the walk as a curve, one for each scene, of up to 6")
  private @Nullable Path chart;

  @Option(
      names = "--polygons",
      paramLabel = "F.csv",
      description =
          "writes the polygons over the walk to a table with the columns scene,t,polygons: a row"
              + " when they change, and for the last frame")
  private @Nullable Path table;

  private final Map<Path, Curve> curves = new ConcurrentHashMap<>();

  /** The polygons of one scene; frames that change nothing are not kept. */
  private static final class Curve {
    private final List<StepChart.Step> steps = new ArrayList<>();
    private double end;

    /** Adds a frame; called by the thread that walks through the scene. */
    synchronized void add(double t, long polygons) {
      end = t;
      if (steps.isEmpty() || steps.get(steps.size() - 1).value() != polygons) {
        steps.add(new StepChart.Step(t, polygons));
      }
    }

    synchronized List<StepChart.Step> steps() {
      List<StepChart.Step> all = new ArrayList<>(steps);
      if (!all.isEmpty() && all.get(all.size() - 1).t() < end) {
        all.add(new StepChart.Step(end, all.get(all.size() - 1).value()));
      }
      return all;
    }
  }

  /** Checks the files before the walk. */
  void check(List<Path> scenes, Path path) throws IOException {
    if (chart == null && table == null) {
      return;
    }
    if (chart != null && ChartFileWriter.of(chart).isEmpty()) {
      throw CommandException.usage("--chart needs a file that ends in .svg or .png, not " + chart);
    }
    if (chart != null && scenes.size() > StepChart.MOST) {
      throw CommandException.usage(
          "--chart draws up to %d scenes, not %d".formatted(StepChart.MOST, scenes.size()));
    }
    OutputFile.check("--chart", chart);
    OutputFile.check("--polygons", table, ".csv");
    CommandFileCheck files = new CommandFileCheck().reads("--path", path);
    scenes.forEach(scene -> files.reads("the scene", scene));
    files.writes("--chart", chart).writes("--polygons", table).check();
  }

  /** Keeps the polygons of a frame. */
  void stepped(Path scene, double t, long polygons) {
    if (chart != null || table != null) {
      curves.computeIfAbsent(scene, key -> new Curve()).add(t, polygons);
    }
  }

  /** Writes what was asked for, of the scenes that could be walked through. */
  void write(List<Path> scenes, Path path) throws IOException {
    CsvWriter csv = new CsvWriter();
    csv.row("scene", "t", "polygons");
    List<StepChart.Curve> drawn = new ArrayList<>();
    for (Path scene : scenes) {
      Optional<Curve> curve = Optional.ofNullable(curves.get(scene));
      if (curve.isPresent()) {
        drawn.add(new StepChart.Curve(scene.getFileName().toString(), curve.get().steps()));
        curve
            .get()
            .steps()
            .forEach(step -> csv.row(scene.toString(), step.t(), (long) step.value()));
      }
    }
    if (table != null) {
      OutputFile.write(table, csv.toString());
    }
    if (chart != null && !drawn.isEmpty()) {
      ChartFileWriter.of(chart)
          .orElseThrow()
          .write(
              new StepChart(
                  "Polygons along " + path.getFileName(),
                  "polygons of the whole scene with the versions that are shown",
                  drawn));
    }
  }
}
