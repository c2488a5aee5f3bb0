package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.chart.ChartFile;
import org.selectiverenderer.polygon.statistics.PolygonStatistics;
import org.selectiverenderer.polygon.statistics.SceneStatistics;
import org.selectiverenderer.polygon.statistics.ScopeException;
import org.selectiverenderer.polygon.statistics.StatisticsCsv;
import org.selectiverenderer.polygon.statistics.StatisticsJson;
import org.selectiverenderer.polygon.statistics.StatisticsText;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "polygons",
    description =
        "Counts polygons: of each object's versions, and of each part of the scene for every set of"
            + " schemas that the viewer's place can activate.",
    footer = "  ./selective-renderer polygons scenes/trashcan.x3d --chart polygons.svg")
final class PolygonsCommand extends CliCommand {
  private enum Format {
    text,
    csv,
    json
  }

  @Parameters(paramLabel = "SCENE", description = "the X3D scene (.x3d, .x3dz)")
  private Path scene = Path.of("");

  @Option(
      names = "--scope",
      split = ",",
      paramLabel = "DEF",
      description =
          "the groups to be counted (default: the outermost named ones that hold objects in"
              + " versions, else the whole scene)")
  private List<String> scopes = List.of();

  @Option(
      names = "--format",
      defaultValue = "text",
      description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Option(
      names = "--chart",
      paramLabel = "F.png|F.svg",
      description = "draws the figures as bar charts into a file, 1200 pixels wide")
  private @Nullable Path chart;

  PolygonsCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    Optional<ChartFile> chartFile = Optional.ofNullable(chart).flatMap(ChartFile::of);
    if (chart != null && chartFile.isEmpty()) {
      throw CommandFailure.usage("--chart takes a file that ends in .png or .svg, not " + chart);
    }
    OutputFile.check("--chart", chart);
    Problems problems = new Problems(console()::problem);
    SceneStatistics statistics;
    try {
      statistics = PolygonStatistics.of(scene, scopes, problems);
    } catch (ScopeException e) {
      throw CommandFailure.usage("--scope: " + e.getMessage());
    }
    console()
        .out()
        .print(
            switch (format) {
              case text -> StatisticsText.of(statistics);
              case csv -> StatisticsCsv.of(statistics);
              case json -> StatisticsJson.of(statistics);
            });
    console().out().flush();
    if (chartFile.isPresent()) {
      chartFile.get().write(statistics);
    }
    return ExitStatus.of(problems);
  }
}
