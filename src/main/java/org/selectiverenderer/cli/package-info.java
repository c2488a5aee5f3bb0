/**
 * The command line: the program's entry point, its commands and the report of their failures. There
 * is one picocli command per file, without logic; the commands are in packages by the kind of their
 * users.
 *
 * <p>In: arguments, the standard streams. Out: data on standard output, messages on standard error,
 * an {@link org.selectiverenderer.command.output.ExitStatus}. May use every other package; no other
 * package uses it. Only this package uses the standard streams and ends the process.
 *
 * <p>To add a command: a file with a class that extends {@link
 * org.selectiverenderer.command.CliCommand} in {@code cli.view}, {@code cli.author} or {@code
 * cli.experiment}, and a line in {@link org.selectiverenderer.cli.DesktopCommandProvider} or {@link
 * org.selectiverenderer.cli.experiment.ExperimentCommand}. A module that a distribution may leave
 * out has a {@link org.selectiverenderer.command.CommandProvider} of its own.
 */
@NullMarked
package org.selectiverenderer.cli;

import org.jspecify.annotations.NullMarked;
