package org.selectiverenderer.cli;

import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Makes docs/options.md of picocli's model: what {@code --help} says of every command. */
final class OptionsPageGenerator {
  private static final String HEAD =
      """
      # Options of all commands

      What each command is for, and what all of them have in common, is told in [commands.md](commands.md). Here is what
      their `--help` says.

      <!-- OptionsPageTest writes this page: do not edit it by hand. -->

      These options go with every command:

      """;

  private OptionsPageGenerator() {}

  static String of(CommandSpec root) {
    StringBuilder page = new StringBuilder(HEAD);
    table(page, root);
    commands(root).forEach(command -> section(page, command, "##"));
    return page.toString();
  }

  private static Stream<CommandSpec> commands(CommandSpec command) {
    return command.subcommands().values().stream()
        .map(line -> line.getCommandSpec())
        .filter(sub -> !sub.usageMessage().hidden());
  }

  private static void section(StringBuilder page, CommandSpec command, String level) {
    String name = command.qualifiedName(" ");
    page.append('\n').append(level).append(' ').append(name.substring(name.indexOf(' ') + 1));
    page.append("\n\n");
    for (String line : command.usageMessage().description()) {
      page.append(prose(line)).append('\n');
    }
    String[] example = command.usageMessage().footer();
    if (example.length > 0) {
      page.append("\n```\n");
      for (String line : example) {
        page.append(plain(line).stripTrailing().replaceFirst("^  ", "")).append('\n');
      }
      page.append("```\n");
    }
    if (args(command).findAny().isPresent()) {
      page.append('\n');
      table(page, command);
    }
    commands(command).forEach(sub -> section(page, sub, level + "#"));
  }

  private static void table(StringBuilder page, CommandSpec command) {
    page.append("| option | does |\n| --- | --- |\n");
    args(command).forEach(arg -> page.append(row(arg)));
  }

  /** Parameters, then options; those that every command has are told once, of the root. */
  private static Stream<ArgSpec> args(CommandSpec command) {
    CommandSpec root = command.root();
    return Stream.concat(
        command.positionalParameters().stream().filter(arg -> !arg.hidden()),
        command.options().stream()
            .filter(option -> !option.hidden())
            .filter(option -> command == root || root.findOption(option.longestName()) == null));
  }

  private static String row(ArgSpec arg) {
    String says = plain(String.join(" ", arg.description())).replaceAll("\\s+", " ").strip();
    return "| %s | %s |\n".formatted(code(names(arg)), prose(says));
  }

  private static String names(ArgSpec arg) {
    if (!(arg instanceof OptionSpec option)) {
      return arg.paramLabel();
    }
    String names = String.join(", ", List.of(option.names()));
    return option.arity().max() == 0 ? names : names + " " + option.paramLabel();
  }

  private static String code(String text) {
    return "`" + text.replace("|", "\\|") + "`";
  }

  /** Signs that mean something to Markdown stand for themselves. */
  private static String prose(String text) {
    return plain(text).replaceAll("([\\\\`*_<>|\\[\\]])", "\\\\$1");
  }

  /** Without picocli's marks for styles, and with its format's percent signs resolved. */
  private static String plain(String text) {
    return Ansi.OFF.string(text).replace("%n", "\n").replace("%%", "%");
  }
}
