package org.selectiverenderer.bench.command;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.bench.GrowthSeries;
import org.selectiverenderer.bench.HeavySceneGenerator;
import org.selectiverenderer.bench.measure.Benchmark;
import org.selectiverenderer.bench.measure.BenchmarkTextReport;
import org.selectiverenderer.bench.measure.GrowthBenchmark;
import org.selectiverenderer.bench.measure.GrowthTextReport;
import org.selectiverenderer.bench.measure.VersionBenchmark;
import org.selectiverenderer.bench.versions.VersionComparison;
import org.selectiverenderer.bench.versions.VersionComparisonReport;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.InterruptHandler;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.render.context.GlAvailability;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

@Command(
    name = "bench",
    description = {
      "Measures this machine: reading, loading, frames per second, activation, memory.",
      "Takes a minute or two; run nothing else on the machine meanwhile."
    },
    footer = {
      "  ./selective-renderer bench --format text",
      "  ./selective-renderer bench --growth --format text",
      "  ./selective-renderer bench --growth --series street --output street.json",
      "  ./selective-renderer bench --budget --output budget.json --format text"
    })
final class BenchCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "json",
      description = "format of the report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.json;

  @Option(
      names = "--output",
      paramLabel = "F.json",
      description = "writes the figures as JSON to a file")
  private @Nullable Path output;

  @Option(
      names = "--runs",
      defaultValue = "3",
      paramLabel = "N",
      description =
          "number of runs of each scene; the median is reported (default: ${DEFAULT-VALUE})")
  private int runs;

  @Option(
      names = "--growth",
      description =
          "measures instead how loading, memory and frames grow with the number of objects, "
              + "sensors, Switches, Inlines, triangles, apartments and models")
  private boolean growth;

  @Option(
      names = "--series",
      split = ",",
      paramLabel = "NAME",
      description =
          "series that --growth measures: ${COMPLETION-CANDIDATES} (default: all of them, without "
              + "the street of 1,024 apartments)")
  private @Nullable Set<GrowthSeries> series;

  @Option(
      names = "--budget",
      description =
          "compares instead what pictures lose at equal budgets of triangles if versions are chosen "
              + "by distance, by their error on the screen, by the thesis's rule and by --budget of "
              + "run, on the apartment and a street of four")
  private boolean budget;

  @Option(
      names = "--poses",
      defaultValue = "12",
      paramLabel = "N",
      description = "poses of which --budget compares pictures (default: ${DEFAULT-VALUE})")
  private int poses;

  @Option(
      names = "--scenes",
      paramLabel = "DIR",
      description =
          "writes the heavy and the light scene to folders heavy and light in DIR instead of "
              + "measuring, for other browsers; replaces what is there")
  private @Nullable Path scenes;

  private final String program;

  /**
   * @param program the name of the class that the measured processes run
   */
  public BenchCommand(Console console, String program) {
    super(console);
    this.program = program;
  }

  @Override
  public ExitStatus run() throws IOException {
    if (!growth && series != null) {
      throw CommandException.usage("--series chooses what --growth measures; give --growth too");
    }
    if (runs < 1) {
      throw CommandException.usage("--runs must be a whole number of at least 1");
    }
    if (budget && (growth || scenes != null)) {
      throw CommandException.usage("--budget measures alone; leave out --growth and --scenes");
    }
    if (poses < 1) {
      throw CommandException.usage("--poses must be a whole number of at least 1");
    }
    if (scenes != null) {
      writeScenes(scenes);
      return ExitStatus.DONE;
    }
    OutputFile.check("--output", output);
    ObjectNode report = InterruptHandler.interrupts(this::measured);
    if (output != null) {
      OutputFile.write(output, JsonWriter.of(report));
    }
    if (output == null || format == Format.text) {
      console().out().print(format == Format.text ? text(report) : JsonWriter.of(report));
    }
    return ExitStatus.DONE;
  }

  private void writeScenes(Path folder) throws IOException {
    if (growth || output != null) {
      throw CommandException.usage("--scenes does not measure; leave out --growth and --output");
    }
    for (BenchScene written :
        List.of(HeavySceneGenerator.heavy(folder), HeavySceneGenerator.light(folder))) {
      console().line(written.scene().toString());
    }
  }

  private ObjectNode measured() throws IOException, InterruptedException {
    if (budget) {
      return compared();
    }
    return growth ? growth() : whole();
  }

  private ObjectNode compared() throws IOException {
    needDisplay();
    return VersionBenchmark.run(new VersionComparison(poses, this::progress));
  }

  private ObjectNode whole() throws IOException, InterruptedException {
    needDisplay();
    return new Benchmark(program, runs, this::progress).run();
  }

  private static void needDisplay() {
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandException.environment(reason);
            });
  }

  private ObjectNode growth() throws IOException, InterruptedException {
    Optional<String> undrawn = GlAvailability.check();
    undrawn.ifPresent(reason -> progress("nothing is drawn: " + reason));
    return new GrowthBenchmark(program, undrawn.isEmpty(), runs, this::progress)
        .run(series != null ? series : EnumSet.allOf(GrowthSeries.class), series != null);
  }

  private void progress(String step) {
    console().message("bench: " + step);
  }

  private String text(ObjectNode report) {
    if (budget) {
      return VersionComparisonReport.of(report.get("budget"));
    }
    return growth ? GrowthTextReport.of(report) : BenchmarkTextReport.of(report);
  }
}
