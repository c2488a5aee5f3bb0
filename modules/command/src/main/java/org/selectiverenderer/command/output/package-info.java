/**
 * The output of commands: the console, checks of output files before the work begins, failures with
 * a message of one sentence, exit statuses.
 *
 * <p>In: the standard streams, file names. Out: text on them. Uses {@code app.run} and {@code
 * walkthrough.timeline} for what a run tells, {@code base.files} and {@code base.problem}; the rest
 * of {@code cli} uses it.
 */
@NullMarked
package org.selectiverenderer.command.output;

import org.jspecify.annotations.NullMarked;
