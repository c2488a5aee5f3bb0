package org.selectiverenderer.cli.bundle;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.selectiverenderer.command.HelpFormatter;
import org.selectiverenderer.command.ProgramVersion;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * Writes manual pages in the macros of man(7), one for the program and one for each command, from
 * picocli's model: the content of {@code --help} in the order and under the headings of a manual.
 */
final class ManPageWriter {
  private static final String EXIT_STATUS =
      ".SH EXIT STATUS\n"
          + ".TP\n0\nDone.\n"
          + ".TP\n1\nDone as far as possible; the input has problems.\n"
          + ".TP\n2\nWrong usage, or a file or a device could not be used.\n";

  private static final String ENVIRONMENT =
      ".SH ENVIRONMENT\n"
          + ".TP\nSELECTIVE_RENDERER_JAVA_OPTS\n"
          + "Further flags for Java, such as \\-Xmx4g.\n"
          + ".TP\nSELECTIVE_RENDERER_SAI\n"
          + "For the command sai: another browser's jars, as a folder or a class path.\n"
          + ".TP\nSELECTIVE_RENDERER_DEBUG\n"
          + "1 prints the stack trace of a failure.\n";

  private ManPageWriter() {}

  /** Returns the pages keyed by their names without the section; hidden commands have none. */
  static SortedMap<String, String> of(CommandSpec root, String version) {
    SortedMap<String, String> pages = new TreeMap<>();
    add(root, version, pages);
    return pages;
  }

  private static void add(CommandSpec command, String version, SortedMap<String, String> pages) {
    pages.put(command.qualifiedName("-"), page(command, version));
    commands(command).forEach(sub -> add(sub, version, pages));
  }

  private static Stream<CommandSpec> commands(CommandSpec command) {
    return command.subcommands().values().stream()
        .map(line -> line.getCommandSpec())
        .filter(sub -> !sub.usageMessage().hidden());
  }

  private static String page(CommandSpec command, String version) {
    Help help = new HelpFormatter(command, Help.defaultColorScheme(Ansi.OFF));
    StringBuilder page = new StringBuilder();
    String name = command.qualifiedName("-");
    page.append(".TH \"").append(roff(name)).append("\" 1 \"\" \"");
    page.append(roff(ProgramVersion.PROGRAM + " " + version)).append("\" \"User commands\"\n");
    // Lines are wrapped at the reader's window width: never within a word, such as an option value.
    page.append(".ad l\n.nh\n");
    String[] description = command.usageMessage().description();
    page.append(".SH NAME\n").append(roff(name)).append(" \\- ");
    page.append(roff(summary(description))).append('\n');
    page.append(".SH SYNOPSIS\n");
    page.append(roff(help.synopsis(0).strip().replaceAll("\\s+", " "))).append('\n');
    page.append(".SH DESCRIPTION\n");
    for (String line : description) {
      page.append(roff(plain(line))).append("\n.br\n");
    }
    List<PositionalParamSpec> parameters =
        command.positionalParameters().stream().filter(p -> !p.hidden()).toList();
    if (!parameters.isEmpty()) {
      page.append(".SH PARAMETERS\n");
      parameters.forEach(p -> entry(page, p.paramLabel(), p.description()));
    }
    page.append(".SH OPTIONS\n");
    command.options().stream()
        .filter(option -> !option.hidden())
        .forEach(option -> entry(page, names(option), option.description()));
    List<CommandSpec> commands = commands(command).toList();
    if (!commands.isEmpty()) {
      page.append(".SH COMMANDS\n");
      for (CommandSpec sub : commands) {
        entry(page, sub.name(), sub.usageMessage().description());
      }
    }
    String[] footer = command.usageMessage().footer();
    if (footer.length > 0) {
      page.append(".SH EXAMPLE\n.nf\n");
      for (String line : footer) {
        // Installed, the program is on the path.
        page.append(
            roff(plain(line).replace("./" + ProgramVersion.PROGRAM, ProgramVersion.PROGRAM)));
        page.append('\n');
      }
      page.append(".fi\n");
    }
    page.append(EXIT_STATUS).append(ENVIRONMENT);
    seeAlso(page, command, commands);
    return page.toString();
  }

  private static void seeAlso(StringBuilder page, CommandSpec command, List<CommandSpec> commands) {
    List<String> others = new ArrayList<>();
    if (command.parent() != null) {
      others.add(command.parent().qualifiedName("-"));
    }
    commands.forEach(sub -> others.add(sub.qualifiedName("-")));
    if (!others.isEmpty()) {
      page.append(".SH SEE ALSO\n");
      String links =
          String.join(",\n", others.stream().map(o -> ".BR " + roff(o) + " (1)").toList());
      page.append(links).append('\n');
    }
  }

  private static void entry(StringBuilder page, String term, String[] description) {
    page.append(".TP\n\\fB").append(roff(term)).append("\\fR\n");
    page.append(roff(plain(String.join(" ", description)))).append('\n');
  }

  private static String names(OptionSpec option) {
    String names = String.join(", ", option.names());
    return option.arity().max() == 0 ? names : names + " " + option.paramLabel();
  }

  /** Returns the first sentence of a description, which whatis(1) lists. */
  private static String summary(String[] description) {
    String text = plain(String.join(" ", description));
    int end = text.indexOf(". ");
    String first = end < 0 ? text : text.substring(0, end);
    return first.endsWith(".") ? first.substring(0, first.length() - 1) : first;
  }

  /** Returns a text without picocli's style markup and with its format specifiers resolved. */
  private static String plain(String text) {
    return Ansi.OFF.string(text).replace("%n", "\n").replace("%%", "%");
  }

  /** Escapes the characters of a text that roff would interpret. */
  private static String roff(String text) {
    return text.replace("\\", "\\e").replace("-", "\\-").replaceAll("(?m)^(?=[.'])", "\\\\&");
  }
}
