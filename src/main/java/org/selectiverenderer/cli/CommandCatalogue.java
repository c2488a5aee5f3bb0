package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.apartment.command.ApartmentCommand;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.bench.command.BenchCommand;
import org.selectiverenderer.cli.author.ConvertCommand;
import org.selectiverenderer.cli.author.EnrichCommand;
import org.selectiverenderer.cli.author.PolygonsCommand;
import org.selectiverenderer.cli.author.SimplifyCommand;
import org.selectiverenderer.cli.author.ValidateCommand;
import org.selectiverenderer.cli.author.VersionsCommand;
import org.selectiverenderer.cli.bundle.BundleFilesCommand;
import org.selectiverenderer.cli.experiment.ExperimentCommand;
import org.selectiverenderer.cli.view.DoctorCommand;
import org.selectiverenderer.cli.view.RunCommand;
import org.selectiverenderer.cli.view.SaiCommand;
import org.selectiverenderer.cli.view.SimulateCommand;
import org.selectiverenderer.cli.view.TrackCommand;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.enricher.EnricherApp;
import org.selectiverenderer.enricher.WindowIcon;
import org.selectiverenderer.radiosity.command.RadiosityCommand;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Creates the commands, in the order of {@code --help}. */
final class CommandCatalogue {
  private CommandCatalogue() {}

  private static final List<String> NAMES =
      List.of(
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
          "apartment",
          "radiosity",
          "bench",
          "doctor",
          "sai",
          BundleFilesCommand.NAME);

  /** Creates all commands. */
  static List<CliCommand> commands(Console console) {
    return NAMES.stream().flatMap(name -> command(name, console).stream()).toList();
  }

  /**
   * Creates the commands that picocli needs for a command line: only its first word's command, or
   * else all, for help, suggestions and options before a command. Reading the options of all
   * commands takes longer than the start of Java.
   */
  static List<CliCommand> commands(Console console, String[] args) {
    Optional<CliCommand> named = args.length == 0 ? Optional.empty() : command(args[0], console);
    return named.map(List::of).orElseGet(() -> commands(console));
  }

  /**
   * Returns whether a command line opens a window with a scene, so that OpenGL can be started
   * early.
   */
  static boolean draws(String[] args) {
    return args.length > 1
        && args[0].equals("run")
        && Arrays.stream(args).noneMatch(arg -> arg.equals("--help") || arg.equals("-h"));
  }

  private static Optional<CliCommand> command(String name, Console console) {
    return Optional.ofNullable(
        switch (name) {
          case "run" -> new RunCommand(console);
          case "simulate" -> new SimulateCommand(console);
          case "validate" -> new ValidateCommand(console, System.in);
          case "enrich" -> new EnrichCommand(console, CommandCatalogue::enricher);
          case "convert" -> new ConvertCommand(console);
          case "simplify" -> new SimplifyCommand(console);
          case "versions" -> new VersionsCommand(console);
          case "polygons" -> new PolygonsCommand(console);
          case "track" -> new TrackCommand(console);
          case "experiment" -> new ExperimentCommand(console);
          case "apartment" -> new ApartmentCommand(console);
          case "radiosity" -> new RadiosityCommand(console);
          case "bench" -> new BenchCommand(console, Main.class.getName());
          case "doctor" -> new DoctorCommand(console, Main.class.getName());
          case "sai" -> new SaiCommand(console, System.in);
          case BundleFilesCommand.NAME ->
              new BundleFilesCommand(
                  console,
                  () -> new CommandRunner(console).model(commands(console)),
                  WindowIcon::image);
          default -> null;
        });
  }

  private static ExitStatus enricher(Optional<Path> scene, ContentAccessPolicy access)
      throws IOException {
    LibraryProperties.swingFirst();
    Path settings =
        SettingsFolder.of(
            System.getProperty("os.name", ""),
            Path.of(System.getProperty("user.home", "")),
            System.getenv());
    try {
      EnricherApp.run(scene, access, settings);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ExitStatus.DONE;
  }
}
