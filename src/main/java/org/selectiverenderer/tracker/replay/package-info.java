/**
 * Records that were written to a file, played again.
 *
 * <p>In: the CSV of {@code track --output} or a head log, columns found by name. Out: a tracker at
 * the pace of the clock ({@link org.selectiverenderer.tracker.replay.ReplaySource}) or of the
 * frames ({@link org.selectiverenderer.tracker.replay.SteppedReplay}). Uses {@code tracker}, {@code
 * tracker.live}, {@code base.csv} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.replay;

import org.jspecify.annotations.NullMarked;
