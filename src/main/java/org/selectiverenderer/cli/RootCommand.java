package org.selectiverenderer.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The program itself: what all commands share, and what is printed without a command. */
@Command(
    name = RootCommand.NAME,
    scope = ScopeType.INHERIT,
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    sortOptions = false,
    usageHelpWidth = 100,
    synopsisSubcommandLabel = "COMMAND",
    description = "Shows X3D scenes and renders them selectively, by memory schemata.",
    descriptionHeading = "%n",
    optionListHeading = "%nOptions:%n",
    parameterListHeading = "%nParameters:%n",
    commandListHeading = "%nCommands:%n",
    footerHeading = "%nExample:%n",
    footer = "  ./" + RootCommand.NAME + " run scenes/trashcan.x3d")
final class RootCommand implements Runnable {
  static final String NAME = "selective-renderer";

  @Option(
      names = "--debug",
      scope = ScopeType.INHERIT,
      description = "Print the stack trace of a failure; also SELECTIVE_RENDERER_DEBUG=1.")
  private boolean debug;

  /** Whether a failure shows its stack trace. */
  boolean debug() {
    return debug || debugByEnvironment();
  }

  static boolean debugByEnvironment() {
    return "1".equals(System.getenv("SELECTIVE_RENDERER_DEBUG"));
  }

  @Override
  public void run() {
    throw CommandFailure.usage("no command given");
  }
}
