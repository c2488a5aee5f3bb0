package org.selectiverenderer.cli;

import java.util.List;

/** The commands, in the order of {@code --help}. */
final class CommandCatalogue {
  private CommandCatalogue() {}

  static List<CliCommand> commands(Console console) {
    return List.of(
        new RunCommand(console),
        new SimulateCommand(console),
        new SimplifyCommand(console),
        new VersionsCommand(console),
        new PolygonsCommand(console),
        new ValidateCommand(console, System.in),
        new ApartmentCommand(console),
        new BenchCommand(console),
        new SaiCommand(console, System.in));
  }
}
