/**
 * Trackers that send text: bytes to lines, lines to angles, without allocating per line.
 *
 * <p>In: bytes in pieces as they arrive. Out: angles into an {@link
 * org.selectiverenderer.tracker.pose.Intake}.
 */
@NullMarked
package org.selectiverenderer.tracker.text;

import org.jspecify.annotations.NullMarked;
