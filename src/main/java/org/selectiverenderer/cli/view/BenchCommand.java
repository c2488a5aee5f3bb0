package org.selectiverenderer.cli.view;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.bench.measure.Benchmark;
import org.selectiverenderer.bench.measure.BenchmarkText;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.output.OutputFile;
import org.selectiverenderer.runtime.render.context.GlAvailability;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

@Command(
    name = "bench",
    description = {
      "Measures this machine: reading, loading, frames per second, activation, memory.",
      "Takes a minute or two; run nothing else on the machine meanwhile."
    },
    footer = "  ./selective-renderer bench --format text")
public final class BenchCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Option(
      names = "--format",
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
    if (runs < 1) {
      throw CommandFailure.usage("--runs must be a whole number of at least 1");
    }
    OutputFile.check("--output", output);
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandFailure.environment(reason);
            });
    try {
      ObjectNode report =
          new Benchmark(program, runs, step -> console().message("bench: " + step)).run();
      if (output != null) {
        OutputFile.write(output, JsonText.of(report));
      }
      if (output == null || format == Format.text) {
        console()
            .out()
            .print(format == Format.text ? BenchmarkText.of(report) : JsonText.of(report));
      }
      return ExitStatus.DONE;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandFailure.environment("interrupted");
    }
  }
}
