package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.cli.author.ApartmentCommand;
import org.selectiverenderer.cli.author.ConvertCommand;
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
import org.selectiverenderer.x3d.files.ContentAccess;

/** The commands, in the order of {@code --help}. */
final class CommandCatalogue {
  private CommandCatalogue() {}

  /** All commands. */
  static List<CliCommand> commands(Console console) {
    return makers().values().stream().map(maker -> maker.apply(console)).toList();
  }

  /**
   * The commands that picocli must know for a command line: the one that it begins with, or else
   * all, for help, suggestions and options before a command. To look at the options of all of them
   * takes longer than Java takes to start.
   */
  static List<CliCommand> commands(Console console, String[] args) {
    Function<Console, CliCommand> named = args.length == 0 ? null : makers().get(args[0]);
    return named == null ? commands(console) : List.of(named.apply(console));
  }

  /** Whether a command line shows a scene, as soon as it can. */
  static boolean draws(String[] args) {
    return args.length > 1
        && args[0].equals("run")
        && Arrays.stream(args).noneMatch(arg -> arg.equals("--help") || arg.equals("-h"));
  }

  /** By name. */
  private static Map<String, Function<Console, CliCommand>> makers() {
    Map<String, Function<Console, CliCommand>> all = new LinkedHashMap<>();
    all.put("run", RunCommand::new);
    all.put("simulate", SimulateCommand::new);
    all.put("validate", console -> new ValidateCommand(console, System.in));
    all.put("enrich", console -> new EnrichCommand(console, CommandCatalogue::enricher));
    all.put("convert", ConvertCommand::new);
    all.put("simplify", SimplifyCommand::new);
    all.put("versions", VersionsCommand::new);
    all.put("polygons", PolygonsCommand::new);
    all.put("track", TrackCommand::new);
    all.put("experiment", ExperimentCommand::new);
    all.put("apartment", ApartmentCommand::new);
    all.put("radiosity", RadiosityCommand::new);
    all.put("bench", console -> new BenchCommand(console, Main.class.getName()));
    all.put("sai", console -> new SaiCommand(console, System.in));
    return all;
  }

  private static ExitStatus enricher(Optional<Path> scene, ContentAccess access)
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
