package org.selectiverenderer.cli.option;

import picocli.CommandLine.Option;

/** For people or for programs. */
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

  /** Whether JSON is wanted instead of text. */
  public boolean json() {
    return format == Format.json;
  }
}
