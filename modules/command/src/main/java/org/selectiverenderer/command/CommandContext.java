package org.selectiverenderer.command;

import java.io.InputStream;
import java.util.function.Supplier;
import org.selectiverenderer.command.output.Console;
import picocli.CommandLine;

/**
 * What the program gives to a command.
 *
 * @param console for data and messages
 * @param input standard input of the process
 * @param mainClass fully qualified name of the program's entry point, for commands that start the
 *     program again in a process of its own
 * @param model picocli's model of all commands, for the generation of documentation
 */
public record CommandContext(
    Console console, InputStream input, String mainClass, Supplier<CommandLine> model) {}
