package org.selectiverenderer.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;
import org.selectiverenderer.cli.bundle.BundleFilesCommand;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.CommandContext;
import org.selectiverenderer.command.CommandProvider;
import org.selectiverenderer.command.output.Console;

/**
 * Creates the commands that the modules on the class path offer, in the order of {@code --help}.
 */
final class CommandCatalogue {
  /**
   * The order of {@code --help}: what most users need first. Commands that are not named here come
   * last, by their names.
   */
  private static final List<String> ORDER =
      List.of(
          "start",
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
          "examples",
          "doctor",
          "sai",
          BundleFilesCommand.NAME);

  private CommandCatalogue() {}

  /** Returns all commands. */
  static List<CliCommand> commands(Console console) {
    List<Offer> offers = new ArrayList<>();
    for (CommandProvider provider : providers()) {
      provider.names().forEach(name -> offers.add(new Offer(name, provider)));
    }
    offers.sort(Comparator.comparingInt(Offer::position).thenComparing(Offer::name));
    CommandContext context = context(console);
    return offers.stream().map(offer -> offer.provider().create(offer.name(), context)).toList();
  }

  /**
   * Returns the commands that picocli must know for a command line: the command that the line
   * begins with, or else all of them, for help, suggestions and options before a command. To
   * inspect the options of all commands takes longer than Java takes to start.
   */
  static List<CliCommand> commands(Console console, String[] args) {
    if (args.length > 0) {
      for (CommandProvider provider : providers()) {
        if (provider.names().contains(args[0])) {
          return List.of(provider.create(args[0], context(console)));
        }
      }
    }
    return commands(console);
  }

  /** Returns whether a command line shows a scene, which is to appear as soon as it can. */
  static boolean draws(String[] args) {
    return args.length > 1
        && args[0].equals("run")
        && Arrays.stream(args).noneMatch(arg -> arg.equals("--help") || arg.equals("-h"));
  }

  private static Iterable<CommandProvider> providers() {
    return ServiceLoader.load(CommandProvider.class, CommandCatalogue.class.getClassLoader());
  }

  private static CommandContext context(Console console) {
    return new CommandContext(
        console,
        System.in,
        Main.class.getName(),
        () -> new CommandRunner(console).model(commands(console)));
  }

  private record Offer(String name, CommandProvider provider) {
    int position() {
      int position = ORDER.indexOf(name);
      return position < 0 ? ORDER.size() : position;
    }
  }
}
