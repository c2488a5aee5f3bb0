/**
 * The command line: the program's entry, its commands and what becomes of their failures. One
 * picocli command per file and no logic; the commands lie in packages by what their users are
 * about.
 *
 * <p>In: arguments, the standard streams. Out: data on standard output, messages on standard error,
 * an {@link org.selectiverenderer.cli.output.ExitStatus}. May use every other package; no other
 * package uses it. It alone touches the standard streams and ends the process.
 *
 * <p>To add a command: a file with a class that extends {@link
 * org.selectiverenderer.cli.base.CliCommand} in {@code cli.view}, {@code cli.author} or {@code
 * cli.experiment}, and a line in {@link org.selectiverenderer.cli.CommandCatalogue} or {@link
 * org.selectiverenderer.cli.experiment.ExperimentCommand}.
 */
@NullMarked
package org.selectiverenderer.cli;

import org.jspecify.annotations.NullMarked;
