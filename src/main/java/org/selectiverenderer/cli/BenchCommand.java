package org.selectiverenderer.cli;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.bench.measure.Benchmark;
import org.selectiverenderer.bench.measure.BenchmarkText;
import org.selectiverenderer.runtime.render.context.GlAvailability;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

@Command(
    name = "bench",
    description = {
      "Measures this machine: reading, loading, frames per second, activation, memory.",
      "Takes a minute or two; leave the machine alone meanwhile."
    },
    footer = "  ./selective-renderer bench --format text")
final class BenchCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Option(
      names = "--format",
      defaultValue = "json",
      description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
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
      description = "of each scene; the median counts (default: ${DEFAULT-VALUE})")
  private int runs;

  BenchCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    if (runs < 1) {
      throw CommandFailure.usage("--runs is a number from 1");
    }
    OutputFile.check("--output", output);
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw CommandFailure.environment(reason);
            });
    try {
      ObjectNode report =
          new Benchmark(Main.class.getName(), runs, step -> console().message("bench: " + step))
              .run();
      if (output != null) {
        Files.writeString(output, report.toPrettyString() + "\n", StandardCharsets.UTF_8);
      }
      if (output == null || format == Format.text) {
        console()
            .out()
            .print(
                format == Format.text ? BenchmarkText.of(report) : report.toPrettyString() + "\n");
      }
      return ExitStatus.DONE;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandFailure.environment("interrupted");
    }
  }
}
