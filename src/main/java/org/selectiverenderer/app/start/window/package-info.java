/**
 * The start window, in Swing: what the program can do, its examples with pictures, and what was
 * opened lately.
 *
 * <p>{@code StartWindow} puts it together, {@code Launcher} starts each action as a command in a
 * process of its own, and {@code Examples} copies the examples before they are opened. Files are
 * read on the thread {@code start-reader}; all else is for Swing's event thread. Theme, text size
 * and language are those of the enricher's window. No OpenGL is started here. Uses {@code
 * app.start}, {@code app.examples}, {@code app.process}, {@code app.recent}, {@code enricher.text},
 * {@code enricher.settings} and {@code swing}.
 */
@NullMarked
package org.selectiverenderer.app.start.window;

import org.jspecify.annotations.NullMarked;
