package org.selectiverenderer.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.HelpFormatter;
import org.selectiverenderer.command.ProgramInvocation;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.FailureMessage;
import org.selectiverenderer.command.output.StandardOutputException;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IHelpFactory;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Configures picocli, runs one command and reports a failure in one line. */
final class CommandRunner {
  private final Console console;
  private final RootCommand root = new RootCommand();

  CommandRunner(Console console) {
    this.console = console;
  }

  ExitStatus run(String[] args, List<? extends CliCommand> commands) {
    StringWriter help = new StringWriter();
    try {
      int code = commandLine(commands, help).execute(args);
      // Written here, as picocli prints a stack trace when its own output fails.
      console.coloured(ProgramInvocation.in(help.toString()));
      console.out().flush();
      return ExitStatus.of(code);
    } catch (StandardOutputException | Error e) { // Output can fail as late as in the flush.
      return report(ProgramVersion.PROGRAM, e);
    }
  }

  /** Returns picocli's model of the commands, for the generation of documentation. */
  CommandLine model(List<? extends CliCommand> commands) {
    return commandLine(commands, new StringWriter());
  }

  private CommandLine commandLine(List<? extends CliCommand> commands, StringWriter help) {
    CommandLine line = new CommandLine(root);
    commands.forEach(command -> add(line, command));
    Reports reports = new Reports();
    return line.setHelpFactory(new HelpTexts())
        .setOut(new PrintWriter(help))
        .setErr(new PrintWriter(console.err(), true))
        .setColorScheme(CommandLine.Help.defaultColorScheme(console.colours() ? Ansi.ON : Ansi.OFF))
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setExpandAtFiles(false) // A file may be called @something.
        .setParameterExceptionHandler(reports)
        .setExecutionExceptionHandler(reports);
  }

  // Classes, not lambdas: picocli's class files are old, and Java would generate the lambdas of its
  // types at each start.

  private static final class HelpTexts implements IHelpFactory {
    @Override
    public CommandLine.Help create(CommandSpec command, CommandLine.Help.ColorScheme colours) {
      return new HelpFormatter(command, colours);
    }
  }

  private final class Reports implements IParameterExceptionHandler, IExecutionExceptionHandler {
    @Override
    public int handleParseException(ParameterException failure, String[] args) {
      return report(name(failure.getCommandLine()), CommandException.usage(sentence(failure)))
          .code();
    }

    @Override
    public int handleExecutionException(
        Exception failure, CommandLine command, ParseResult parsed) {
      return report(name(command), failure).code();
    }
  }

  private static void add(CommandLine parent, CliCommand command) {
    CommandLine child = new CommandLine(command);
    parent.addSubcommand(child);
    command.subcommands().forEach(subcommand -> add(child, subcommand));
  }

  private ExitStatus report(String command, Throwable failure) {
    return new FailureReporter(console, root.debug()).report(command, failure);
  }

  private static String sentence(ParameterException failure) {
    if (failure instanceof UnmatchedArgumentException unmatched
        && failure.getCommandLine().getCommand() instanceof RootCommand
        && !unmatched.isUnknownOption()) {
      List<String> near = unmatched.getSuggestions();
      return "unknown command '"
          + unmatched.getUnmatched().get(0)
          + "'"
          + (near.isEmpty() ? "" : "; did you mean " + String.join(" or ", near) + "?");
    }
    return failure.getMessage();
  }

  private static String name(CommandLine command) {
    return command.getCommandSpec().qualifiedName();
  }

  /** Reports the failure of a command in one line and returns the exit status. */
  private static final class FailureReporter {
    private final Console console;
    private final boolean stackTraces;

    /**
     * @param stackTraces whether the stack trace follows the line
     */
    FailureReporter(Console console, boolean stackTraces) {
      this.console = console;
      this.stackTraces = stackTraces;
    }

    /**
     * Reports a failure.
     *
     * @param command the command as typed, such as {@code selective-renderer run}
     */
    ExitStatus report(String command, Throwable failure) {
      if (failure instanceof StandardOutputException output && output.readerHasGone()) {
        return ExitStatus.DONE;
      }
      console.message(command + ": " + FailureMessage.of(failure));
      if (failure instanceof CommandException cause && cause.wrongUsage()) {
        console.message("Try '" + command + " --help'.");
      }
      if (stackTraces) {
        failure.printStackTrace(console.err());
      }
      return ExitStatus.FAILURE;
    }
  }
}
