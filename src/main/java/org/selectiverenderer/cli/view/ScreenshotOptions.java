package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.run.RunResult;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.OutputFile;
import picocli.CommandLine.Option;

/** The options for the screenshots of a run. */
final class ScreenshotOptions {
  @Option(
      names = "--screenshot",
      paramLabel = "F.png",
      description =
          "writes the last picture to a file; its edges are smooth (4 samples per pixel) "
              + "unless --samples says otherwise")
  private @Nullable Path screenshot;

  @Option(
      names = "--operator-screenshot",
      paramLabel = "F.png",
      description = "writes the last picture of the operator's window to a file")
  private @Nullable Path operatorScreenshot;

  /** Checks the options before any work begins. */
  void check() {
    OutputFile.check("--screenshot", screenshot, ".png");
    OutputFile.check("--operator-screenshot", operatorScreenshot, ".png");
  }

  /** Registers the output files. */
  void writes(CommandFileCheck files) {
    files.writes("--screenshot", screenshot).writes("--operator-screenshot", operatorScreenshot);
  }

  /** Returns whether the last picture of the scene is written. */
  boolean ofScene() {
    return screenshot != null;
  }

  /** Returns the file of the operator's picture; null for none. */
  @Nullable Path ofOperator() {
    return operatorScreenshot;
  }

  /** Writes the screenshots at the end of a run. */
  void write(RunResult result, Console console) throws IOException {
    if (screenshot != null && result.screenshot().isPresent()) {
      result.screenshot().get().writePng(screenshot);
    }
    if (operatorScreenshot != null && result.operator().isPresent()) {
      result.operator().get().writePng(operatorScreenshot);
    } else if (operatorScreenshot != null) {
      console.message(
          "--operator-screenshot "
              + operatorScreenshot
              + ": there was no operator's window; nothing is written");
    }
  }
}
