package org.selectiverenderer.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The commands, in the order of {@code --help}. */
final class CommandCatalogue {
  private CommandCatalogue() {}

  static List<CliCommand> commands(Console console) {
    return List.of(
        new RunCommand(console),
        new SimulateCommand(console),
        new ValidateCommand(console, System.in),
        new EnrichCommand(console, CommandCatalogue::noWindow),
        new SimplifyCommand(console),
        new VersionsCommand(console),
        new PolygonsCommand(console),
        new TrackCommand(console),
        new ExperimentCommand(console),
        new ApartmentCommand(console),
        new BenchCommand(console),
        new SaiCommand(console, System.in));
  }

  private static ExitStatus noWindow(Optional<Path> scene) {
    throw CommandFailure.usage(
        "give --apply or --ratings: this build of the enricher has no window");
  }
}
