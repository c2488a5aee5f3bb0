/**
 * The common parts of the commands: the base class {@link
 * org.selectiverenderer.cli.base.CliCommand}, the program's name and version, the layout of the
 * help, the system properties of libraries.
 *
 * <p>May use {@code cli.output}.
 */
@NullMarked
package org.selectiverenderer.cli.base;

import org.jspecify.annotations.NullMarked;
