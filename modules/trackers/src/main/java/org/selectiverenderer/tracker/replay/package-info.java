/**
 * Replay of recorded poses.
 *
 * <p>In: the CSV of {@code track --output} or a head log, with columns found by name. Out: a
 * tracker in real time ({@link org.selectiverenderer.tracker.replay.ReplaySource}) or by the clock
 * of the frames ({@link org.selectiverenderer.tracker.replay.FrameSteppedReplay}). Uses {@code
 * tracker}, {@code tracker.pipeline}, {@code formats.csv} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.replay;

import org.jspecify.annotations.NullMarked;
