/**
 * Opens trackers of every kind.
 *
 * <p>In: a {@link org.selectiverenderer.tracker.TrackerSpec}. Out: a {@link
 * org.selectiverenderer.tracker.HeadTracker} that runs. Stands on top of the devices' packages, and
 * is the only one that knows all of them. Uses {@code tracker}, {@code tracker.live}, {@code
 * tracker.serial}, {@code tracker.net}, {@code tracker.replay} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.open;

import org.jspecify.annotations.NullMarked;
