/**
 * Work beside the author's: every step that may take longer than a blink runs here, with progress
 * and cancel.
 *
 * <p>In: work. Out: its results, on the event dispatch thread. Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.enricher.task;

import org.jspecify.annotations.NullMarked;
