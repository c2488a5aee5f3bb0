/**
 * The command line: one picocli command per file, no logic.
 *
 * <p>In: arguments, the standard streams. Out: data on standard output, messages on standard error,
 * an {@link org.selectiverenderer.cli.ExitStatus}. May use every other package; no other package
 * uses it. It alone touches the standard streams and ends the process.
 *
 * <p>To add a command: a file with a class that extends {@link
 * org.selectiverenderer.cli.CliCommand}, and a line in {@link
 * org.selectiverenderer.cli.CommandCatalogue}.
 */
@NullMarked
package org.selectiverenderer.cli;

import org.jspecify.annotations.NullMarked;
