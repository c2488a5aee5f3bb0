/**
 * The commands that show scenes and set up displays and trackers: {@code run}, {@code simulate},
 * {@code sai}, {@code track}, {@code bench}.
 *
 * <p>May use {@code command}, {@code cli.batch}, {@code cli.option}, {@code command.output} and the
 * packages that implement the commands.
 */
@NullMarked
package org.selectiverenderer.cli.view;

import org.jspecify.annotations.NullMarked;
