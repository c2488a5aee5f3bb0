/**
 * Background tasks with progress and cancellation: everything that may noticeably take time runs
 * here, not on the event dispatch thread.
 *
 * <p>In: work. Out: its results, on the event dispatch thread. Uses nothing else of ours.
 */
@NullMarked
package org.selectiverenderer.enricher.task;

import org.jspecify.annotations.NullMarked;
