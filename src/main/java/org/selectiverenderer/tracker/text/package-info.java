/**
 * Trackers that send text: bytes to lines, lines to angles, without allocating per line.
 *
 * <p>In: bytes in pieces as they arrive. Out: angles into a {@link
 * org.selectiverenderer.tracker.live.PoseSink}. Uses {@code tracker.live} and FastDoubleParser.
 */
@NullMarked
package org.selectiverenderer.tracker.text;

import org.jspecify.annotations.NullMarked;
