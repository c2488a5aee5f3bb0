/**
 * The commands of {@code study}: studies, sessions and their results.
 *
 * <p>May use {@code command}, {@code cli.option}, {@code command.output} and the packages that
 * implement the commands.
 */
@NullMarked
package org.selectiverenderer.cli.experiment;

import org.jspecify.annotations.NullMarked;
