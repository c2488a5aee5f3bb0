package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.OutputFile;
import picocli.CommandLine.Option;

/** The option for the output file of a report, instead of the standard output. */
final class ReportOutputOption {
  @Option(
      names = "--output",
      paramLabel = "F",
      description = "writes to a file (default: standard output)")
  private @Nullable Path output;

  /**
   * @param files the input files of the report
   */
  void check(CommandFileCheck files) throws IOException {
    OutputFile.check("--output", output, "");
    files.writes("--output", output).check();
  }

  void write(String text, Console console) throws IOException {
    if (output == null) {
      console.out().print(text);
      console.out().flush();
    } else {
      OutputFile.writePrivate(output, text);
    }
  }
}
