package org.selectiverenderer.cli.option;

import picocli.CommandLine.Option;

/** The option to print changes without making them. */
public final class DryRunOption {
  @Option(names = "--dry-run", description = "prints what would change and writes nothing")
  private boolean asked;

  public boolean asked() {
    return asked;
  }
}
