/**
 * Commands of the program in processes of their own, which windows start.
 *
 * <p>In: the words of a command. Out: a process that outlives the window, with its lines and its
 * exit status. Uses {@code command} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.app.process;

import org.jspecify.annotations.NullMarked;
