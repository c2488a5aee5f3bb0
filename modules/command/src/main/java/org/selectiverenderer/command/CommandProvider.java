package org.selectiverenderer.command;

import java.util.List;

/**
 * Offers the commands of a module to the command line. The program finds providers by {@link
 * java.util.ServiceLoader}, so a distribution that leaves a module out has one command less and is
 * otherwise the same. A provider is named in {@code
 * META-INF/services/org.selectiverenderer.command.CommandProvider} of its module.
 */
public interface CommandProvider {
  /** Returns the names of the commands, as users type them. */
  List<String> names();

  /**
   * Creates a command. Classes of other commands are not loaded.
   *
   * @param name one of {@link #names}
   */
  CliCommand create(String name, CommandContext context);
}
