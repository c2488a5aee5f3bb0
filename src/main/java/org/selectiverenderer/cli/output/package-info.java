/**
 * Where a command's words and files go, and how it ends: the console, files looked at before the
 * work begins, failures that say one sentence, exit statuses.
 *
 * <p>In: the standard streams, file names. Out: text on them. Uses {@code app.run} and {@code
 * app.timeline} for what a run tells, {@code base.files} and {@code base.problem}; the rest of
 * {@code cli} uses it.
 */
@NullMarked
package org.selectiverenderer.cli.output;

import org.jspecify.annotations.NullMarked;
