package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.document.file.SettingsFolder;
import org.selectiverenderer.enricher.EnricherApp;

/** The commands, in the order of {@code --help}. */
final class CommandCatalogue {
  private CommandCatalogue() {}

  static List<CliCommand> commands(Console console) {
    return List.of(
        new RunCommand(console),
        new SimulateCommand(console),
        new ValidateCommand(console, System.in),
        new EnrichCommand(console, CommandCatalogue::enricher),
        new SimplifyCommand(console),
        new VersionsCommand(console),
        new PolygonsCommand(console),
        new TrackCommand(console),
        new ExperimentCommand(console),
        new ApartmentCommand(console),
        new RadiosityCommand(console),
        new BenchCommand(console),
        new SaiCommand(console, System.in));
  }

  private static ExitStatus enricher(Optional<Path> scene) throws IOException {
    LibraryProperties.swingFirst();
    Path settings =
        SettingsFolder.of(
            System.getProperty("os.name", ""),
            Path.of(System.getProperty("user.home", "")),
            System.getenv());
    try {
      EnricherApp.run(scene, settings);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ExitStatus.DONE;
  }
}
