package org.selectiverenderer.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.lsl.LslLibrary;
import picocli.CommandLine.Option;

/** The options about the Lab Streaming Layer, shared by several commands. */
public final class LslOptions {
  @Option(
      names = "--lsl",
      description =
          "sends poses, what is looked at, and events to the Lab Streaming Layer; needs liblsl")
  private boolean lsl;

  @Option(
      names = "--lsl-library",
      paramLabel = "FILE",
      description =
          "file of liblsl (default: the one that SELECTIVE_RENDERER_LSL names, else the system's)")
  private @Nullable Path library;

  /** Returns whether the user asks for sending. */
  public boolean asked() {
    return lsl;
  }

  /**
   * Returns the library, if it is needed.
   *
   * @param wanted whether it is needed for another reason than {@code --lsl}
   */
  public Optional<LslLibrary> library(boolean wanted) {
    if (!lsl && !wanted) {
      return Optional.empty();
    }
    try {
      return Optional.of(LslLibrary.open(Optional.ofNullable(library)));
    } catch (IOException e) {
      throw CommandException.environment(e.getMessage());
    }
  }
}
