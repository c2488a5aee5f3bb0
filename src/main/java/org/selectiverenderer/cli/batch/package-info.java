/**
 * Runs a command on many files in parallel and prints the results in the order of the files.
 *
 * <p>In: files, and what a command does with one. Out: text on the standard streams, an exit
 * status. Uses {@code command.output}; commands use it.
 */
@NullMarked
package org.selectiverenderer.cli.batch;

import org.jspecify.annotations.NullMarked;
