package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.run.RunResult;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.OutputFile;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options for the output files of a run: screenshots, time line, measurements. */
final class RunOutputOptions {
  @Mixin private ScreenshotOptions pictures = new ScreenshotOptions();

  @Option(
      names = "--timeline",
      paramLabel = "F.jsonl",
      description =
          "writes what happened, one JSON object per line, as simulate --format json does")
  private @Nullable Path timeline;

  @Option(names = "--stats", paramLabel = "F.json", description = "writes the figures of the run")
  private @Nullable Path stats;

  /** Checks the options before any work begins. */
  void check() {
    pictures.check();
    OutputFile.check("--timeline", timeline, "");
    OutputFile.check("--stats", stats, "");
  }

  /** Registers the output files. */
  void writes(CommandFileCheck files) {
    pictures.writes(files);
    files.writes("--timeline", timeline).writes("--stats", stats);
  }

  ScreenshotOptions pictures() {
    return pictures;
  }

  /** Returns the time line's file, not opened yet; empty for none. */
  Optional<TimelineFileWriter> timeline() {
    return timeline == null ? Optional.empty() : Optional.of(new TimelineFileWriter(timeline));
  }

  /** Writes the files at the end of a run. */
  void write(RunResult result, Console console) throws IOException {
    if (stats != null) {
      OutputFile.write(stats, result.figures().json());
    }
    pictures.write(result, console);
  }
}
