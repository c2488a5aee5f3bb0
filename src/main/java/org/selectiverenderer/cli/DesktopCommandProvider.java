package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.start.window.StartWindowApp;
import org.selectiverenderer.app.studies.window.StudyWindowApp;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.cli.author.ConvertCommand;
import org.selectiverenderer.cli.author.EnrichCommand;
import org.selectiverenderer.cli.author.PolygonsCommand;
import org.selectiverenderer.cli.author.SimplifyCommand;
import org.selectiverenderer.cli.author.ValidateCommand;
import org.selectiverenderer.cli.author.VersionsCommand;
import org.selectiverenderer.cli.bundle.BundleFilesCommand;
import org.selectiverenderer.cli.experiment.ExperimentCommand;
import org.selectiverenderer.cli.start.ExamplesCommand;
import org.selectiverenderer.cli.start.StartCommand;
import org.selectiverenderer.cli.view.DoctorCommand;
import org.selectiverenderer.cli.view.RunCommand;
import org.selectiverenderer.cli.view.SaiCommand;
import org.selectiverenderer.cli.view.SimulateCommand;
import org.selectiverenderer.cli.view.TrackCommand;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.CommandContext;
import org.selectiverenderer.command.CommandProvider;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.enricher.EnricherApp;
import org.selectiverenderer.enricher.WindowIcon;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Offers the commands of the desktop application. */
public final class DesktopCommandProvider implements CommandProvider {
  @Override
  public List<String> names() {
    return List.of(
        "start",
        "examples",
        "run",
        "simulate",
        "validate",
        "enrich",
        "convert",
        "simplify",
        "versions",
        "polygons",
        "track",
        "experiment",
        "doctor",
        "sai",
        BundleFilesCommand.NAME);
  }

  @Override
  public CliCommand create(String name, CommandContext context) {
    Console console = context.console();
    return switch (name) {
      case "start" -> new StartCommand(console, DesktopCommandProvider::start);
      case "examples" -> new ExamplesCommand(console);
      case "run" -> new RunCommand(console);
      case "simulate" -> new SimulateCommand(console);
      case "validate" -> new ValidateCommand(console, context.input());
      case "enrich" -> new EnrichCommand(console, DesktopCommandProvider::enricher);
      case "convert" -> new ConvertCommand(console);
      case "simplify" -> new SimplifyCommand(console);
      case "versions" -> new VersionsCommand(console);
      case "polygons" -> new PolygonsCommand(console);
      case "track" -> new TrackCommand(console);
      case "experiment" -> new ExperimentCommand(console, DesktopCommandProvider::studies);
      case "doctor" -> new DoctorCommand(console, context.mainClass());
      case "sai" -> new SaiCommand(console, context.input());
      case BundleFilesCommand.NAME ->
          new BundleFilesCommand(console, context.model(), WindowIcon::image);
      default -> throw new IllegalArgumentException("no command " + name);
    };
  }

  private static ExitStatus start() throws IOException {
    LibraryProperties.swingFirst();
    try {
      StartWindowApp.run(SettingsFolder.ofUser());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ExitStatus.DONE;
  }

  private static ExitStatus studies(Optional<Path> study) throws IOException {
    LibraryProperties.swingFirst();
    try {
      StudyWindowApp.run(study, SettingsFolder.ofUser());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ExitStatus.DONE;
  }

  private static ExitStatus enricher(Optional<Path> scene, ContentAccessPolicy access)
      throws IOException {
    LibraryProperties.swingFirst();
    try {
      EnricherApp.run(scene, access, SettingsFolder.ofUser());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ExitStatus.DONE;
  }
}
