/**
 * What every command is made of: {@link org.selectiverenderer.cli.base.CliCommand}, the program's
 * name, how it is typed, its version, how its help is set out, the properties that libraries read.
 *
 * <p>May use {@code cli.output}.
 */
@NullMarked
package org.selectiverenderer.cli.base;

import org.jspecify.annotations.NullMarked;
