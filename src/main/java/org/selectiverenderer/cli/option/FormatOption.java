package org.selectiverenderer.cli.option;

import picocli.CommandLine.Option;

/** The option for the format of a command's output: text or JSON. */
public final class FormatOption {
  private enum Format {
    text,
    json
  }

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "format of the output: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  /** Returns whether JSON is wanted instead of text. */
  public boolean json() {
    return format == Format.json;
  }
}
