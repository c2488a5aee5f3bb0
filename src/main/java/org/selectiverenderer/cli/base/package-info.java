/**
 * What every command is made of: {@link org.selectiverenderer.cli.base.CliCommand}, the program's
 * name and version, the properties that libraries read.
 *
 * <p>May use {@code cli.output}.
 */
@NullMarked
package org.selectiverenderer.cli.base;

import org.jspecify.annotations.NullMarked;
