package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** A text that goes to a file or to the standard output. */
final class ReportOutput {
  @Option(
      names = "--output",
      paramLabel = "F",
      description = "writes to a file (default: standard output)")
  private @Nullable Path output;

  void check() {
    OutputFile.check("--output", output, "");
  }

  void write(String text, Console console) throws IOException {
    if (output == null) {
      console.out().print(text);
      console.out().flush();
    } else {
      Files.writeString(output, text, StandardCharsets.UTF_8);
    }
  }
}
