/**
 * The common parts of the commands: the base class {@link
 * org.selectiverenderer.command.CliCommand}, the program's name and version, the layout of the
 * help, the system properties of libraries.
 *
 * <p>May use {@code command.output}.
 */
@NullMarked
package org.selectiverenderer.command;

import org.jspecify.annotations.NullMarked;
