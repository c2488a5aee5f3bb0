package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.chart.ChartFile;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.option.SceneArgument;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.output.OutputFile;
import org.selectiverenderer.polygon.count.PolygonStatistics;
import org.selectiverenderer.polygon.count.SceneStatistics;
import org.selectiverenderer.polygon.count.ScopeException;
import org.selectiverenderer.polygon.count.StatisticsCharts;
import org.selectiverenderer.polygon.count.StatisticsCsv;
import org.selectiverenderer.polygon.count.StatisticsJson;
import org.selectiverenderer.polygon.count.StatisticsText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "polygons",
    description =
        "Counts the polygons of each object's versions, and of each part of the "
            + "scene for every set of schemas that can be active there.",
    footer = "  ./selective-renderer polygons scenes/trashcan.x3d --chart polygons.svg")
public final class PolygonsCommand extends CliCommand {
  private enum Format {
    text,
    csv,
    json
  }

  @Mixin private SceneArgument scene = new SceneArgument();

  @Option(
      names = "--scope",
      split = ",",
      paramLabel = "DEF",
      description =
          "groups to count, by DEF (default: the outermost named groups that contain "
              + "objects in versions, else the whole scene)")
  private List<String> scopes = List.of();

  @Option(
      names = "--format",
      defaultValue = "text",
      description = "format of the report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Option(
      names = "--chart",
      paramLabel = "F.png|F.svg",
      description = "draws the figures as bar charts into a file, 1200 pixels wide")
  private @Nullable Path chart;

  public PolygonsCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    Optional<ChartFile> chartFile = Optional.ofNullable(chart).flatMap(ChartFile::of);
    if (chart != null && chartFile.isEmpty()) {
      throw CommandFailure.usage("--chart needs a file that ends in .png or .svg, not " + chart);
    }
    OutputFile.check("--chart", chart);
    Problems problems = new Problems(console()::problem);
    SceneStatistics statistics;
    try {
      statistics = PolygonStatistics.of(scene.file(), scopes, problems);
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
      String title = "Polygons of " + Path.of(statistics.scene()).getFileName();
      chartFile.get().write(title, StatisticsCharts.of(statistics));
    }
    return ExitStatus.of(problems);
  }
}
