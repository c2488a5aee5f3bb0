/**
 * Holds what the start window knows, without a window: the examples that it shows, the commands
 * that it starts, the files that were opened lately, and where the user's documents are.
 *
 * <p>In: the user's settings. Out: values and commands. Uses {@code app.process}, {@code
 * app.recent}, {@code enricher.settings} and {@code base}; {@code app.start.window} shows it.
 */
@NullMarked
package org.selectiverenderer.app.start;

import org.jspecify.annotations.NullMarked;
