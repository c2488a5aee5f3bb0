package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.chart.ChartFile;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.batch.Batch;
import org.selectiverenderer.cli.batch.BatchForm;
import org.selectiverenderer.cli.option.AccessOptions;
import org.selectiverenderer.cli.option.FileArguments;
import org.selectiverenderer.cli.option.ScenesArgument;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.CommandFiles;
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
import org.selectiverenderer.x3d.files.ContentAccess;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "polygons",
    description = {
      "Counts the polygons of each object's versions, and of each part of the "
          + "scene for every set of schemas that can be active there.",
      "Processes several scenes in parallel, one on each processor."
    },
    footer = {
      "  ./selective-renderer polygons scenes/trashcan.x3d --chart polygons.svg",
      "  ./selective-renderer polygons scenes/ --format csv"
    })
public final class PolygonsCommand extends CliCommand {
  private enum Format {
    text,
    csv,
    json
  }

  @Mixin private ScenesArgument scenes = new ScenesArgument();

  @Mixin private AccessOptions access = new AccessOptions();

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
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "format of the report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Option(
      names = "--chart",
      paramLabel = "F.png|F.svg",
      description = "draws the figures as bar charts into a file, 1200 pixels wide")
  private @Nullable Path chart;

  private ContentAccess allowed = ContentAccess.none();

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
    allowed = access.access();
    FileArguments files = scenes.files();
    if (!files.one()) {
      if (chart != null) {
        throw CommandFailure.usage("--chart draws one scene; name one");
      }
      return new Batch(console(), form()).run(files.files(FileFinder.SCENES), this::one);
    }
    Problems problems = new Problems(console()::problem);
    SceneStatistics statistics = count(files.file(), problems);
    new CommandFiles()
        .reads("the scene", files.file())
        .writes("--chart", chart)
        .check(allowed.named());
    console().out().print(format == Format.csv ? StatisticsCsv.of(statistics) : text(statistics));
    console().out().flush();
    if (chartFile.isPresent()) {
      String title = "Polygons of " + Path.of(statistics.scene()).getFileName();
      chartFile.get().write(title, StatisticsCharts.of(statistics));
    }
    return ExitStatus.of(problems);
  }

  private BatchForm form() {
    return switch (format) {
      case text -> BatchForm.TEXTS;
      case csv -> BatchForm.table(StatisticsCsv.headerOfMany());
      case json -> BatchForm.JSON_ARRAY;
    };
  }

  /** Counts one of many scenes. */
  private ExitStatus one(Path scene, Console own) throws IOException {
    Problems problems = new Problems(own::problem);
    SceneStatistics statistics = count(scene, problems);
    own.out().print(format == Format.csv ? StatisticsCsv.rowsOfMany(statistics) : text(statistics));
    return ExitStatus.of(problems);
  }

  private SceneStatistics count(Path scene, Problems problems) throws IOException {
    try {
      return PolygonStatistics.of(scene, scopes, allowed, problems);
    } catch (ScopeException e) {
      throw CommandFailure.usage("--scope: " + e.getMessage());
    }
  }

  private String text(SceneStatistics statistics) {
    return format == Format.json ? StatisticsJson.of(statistics) : StatisticsText.of(statistics);
  }
}
