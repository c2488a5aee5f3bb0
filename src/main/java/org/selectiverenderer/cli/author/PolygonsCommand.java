package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.chart.ChartFileWriter;
import org.selectiverenderer.cli.batch.BatchOutputFormat;
import org.selectiverenderer.cli.batch.BatchRunner;
import org.selectiverenderer.cli.option.FileArguments;
import org.selectiverenderer.cli.option.ScenesArgument;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.polygon.ScenePolygonCounter;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.polygon.SceneStatisticsCharts;
import org.selectiverenderer.polygon.SceneStatisticsCsvWriter;
import org.selectiverenderer.polygon.SceneStatisticsJsonWriter;
import org.selectiverenderer.polygon.SceneStatisticsTextWriter;
import org.selectiverenderer.polygon.UnknownRegionException;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
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

  private ContentAccessPolicy allowed = ContentAccessPolicy.none();

  public PolygonsCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    Optional<ChartFileWriter> chartFile = Optional.ofNullable(chart).flatMap(ChartFileWriter::of);
    if (chart != null && chartFile.isEmpty()) {
      throw CommandException.usage("--chart needs a file that ends in .png or .svg, not " + chart);
    }
    OutputFile.check("--chart", chart);
    allowed = access.access();
    FileArguments files = scenes.files();
    if (!files.one()) {
      if (chart != null) {
        throw CommandException.usage("--chart draws one scene; name one");
      }
      return new BatchRunner(console(), form()).run(files.files(FileFinder.SCENES), this::one);
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    SceneStatistics statistics = count(files.file(), problems);
    new CommandFileCheck()
        .reads("the scene", files.file())
        .writes("--chart", chart)
        .check(allowed.named());
    console()
        .out()
        .print(format == Format.csv ? SceneStatisticsCsvWriter.of(statistics) : text(statistics));
    console().out().flush();
    if (chartFile.isPresent()) {
      String title = "Polygons of " + Path.of(statistics.scene()).getFileName();
      chartFile.get().write(title, SceneStatisticsCharts.of(statistics));
    }
    return ExitStatus.of(problems);
  }

  private BatchOutputFormat form() {
    return switch (format) {
      case text -> BatchOutputFormat.TEXTS;
      case csv -> BatchOutputFormat.table(SceneStatisticsCsvWriter.headerOfMany());
      case json -> BatchOutputFormat.JSON_ARRAY;
    };
  }

  /** Counts one of many scenes. */
  private ExitStatus one(Path scene, Console own) throws IOException {
    ProblemCollector problems = new ProblemCollector(own::problem);
    SceneStatistics statistics = count(scene, problems);
    own.out()
        .print(
            format == Format.csv
                ? SceneStatisticsCsvWriter.rowsOfMany(statistics)
                : text(statistics));
    return ExitStatus.of(problems);
  }

  private SceneStatistics count(Path scene, ProblemCollector problems) throws IOException {
    try {
      return ScenePolygonCounter.of(scene, scopes, allowed, problems);
    } catch (UnknownRegionException e) {
      throw CommandException.usage("--scope: " + e.getMessage());
    }
  }

  private String text(SceneStatistics statistics) {
    return format == Format.json
        ? SceneStatisticsJsonWriter.of(statistics)
        : SceneStatisticsTextWriter.of(statistics);
  }
}
