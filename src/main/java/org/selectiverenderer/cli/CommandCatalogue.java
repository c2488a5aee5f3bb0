package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.cli.author.ApartmentCommand;
import org.selectiverenderer.cli.author.EnrichCommand;
import org.selectiverenderer.cli.author.PolygonsCommand;
import org.selectiverenderer.cli.author.RadiosityCommand;
import org.selectiverenderer.cli.author.SimplifyCommand;
import org.selectiverenderer.cli.author.ValidateCommand;
import org.selectiverenderer.cli.author.VersionsCommand;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.base.LibraryProperties;
import org.selectiverenderer.cli.experiment.ExperimentCommand;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.view.BenchCommand;
import org.selectiverenderer.cli.view.RunCommand;
import org.selectiverenderer.cli.view.SaiCommand;
import org.selectiverenderer.cli.view.SimulateCommand;
import org.selectiverenderer.cli.view.TrackCommand;
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
        new BenchCommand(console, Main.class.getName()),
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
