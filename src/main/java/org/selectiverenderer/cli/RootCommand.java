package org.selectiverenderer.cli;

import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The top-level command: the options and help layout that all commands share. */
@Command(
    name = ProgramVersion.PROGRAM,
    scope = ScopeType.INHERIT,
    mixinStandardHelpOptions = true,
    versionProvider = ProgramVersion.class,
    sortOptions = false,
    usageHelpWidth = 80,
    synopsisSubcommandLabel = "COMMAND",
    description = "Shows X3D scenes and renders them selectively, by memory schemas.",
    descriptionHeading = "%n",
    optionListHeading = "%nOptions:%n",
    parameterListHeading = "%nParameters:%n",
    commandListHeading = "%nCommands:%n",
    footerHeading = "%nExample:%n",
    footer = "  ./" + ProgramVersion.PROGRAM + " run scenes/trashcan.x3d")
final class RootCommand implements Runnable {
  @Option(
      names = "--debug",
      scope = ScopeType.INHERIT,
      description = "Print the stack trace of a failure; SELECTIVE_RENDERER_DEBUG=1 does the same.")
  private boolean debug;

  /** Returns whether a failure prints its stack trace. */
  boolean debug() {
    return debug || debugByEnvironment();
  }

  static boolean debugByEnvironment() {
    return "1".equals(System.getenv("SELECTIVE_RENDERER_DEBUG"));
  }

  @Override
  public void run() {
    throw CommandException.usage("no command given");
  }
}
