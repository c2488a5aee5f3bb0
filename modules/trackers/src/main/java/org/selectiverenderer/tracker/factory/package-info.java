/**
 * The factory of trackers.
 *
 * <p>In: a {@link org.selectiverenderer.tracker.TrackerSpec}. Out: a {@link
 * org.selectiverenderer.tracker.HeadTracker}. Only this package depends on the packages of all
 * devices. Uses {@code tracker}, {@code tracker.pipeline}, {@code tracker.serial}, {@code
 * tracker.net}, {@code tracker.replay} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.factory;

import org.jspecify.annotations.NullMarked;
