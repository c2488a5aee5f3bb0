/**
 * The commands of the first minute: the start window, and the examples.
 *
 * <p>In: command lines. Out: {@code app.start.window} and {@code app.examples} are called.
 */
@NullMarked
package org.selectiverenderer.cli.start;

import org.jspecify.annotations.NullMarked;
