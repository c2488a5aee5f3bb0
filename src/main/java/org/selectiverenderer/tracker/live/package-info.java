/**
 * The way of a record from its arrival to whoever draws, the same for every tracker.
 *
 * <p>In: a {@link org.selectiverenderer.tracker.live.PoseSource}, which knows one protocol, and
 * filters for {@link org.selectiverenderer.tracker.TrackerOptions}. Out: a {@link
 * org.selectiverenderer.tracker.live.LiveTracker} with its thread, the {@link
 * org.selectiverenderer.tracker.live.NewestPose}, health, and problems said once.
 *
 * <pre>
 *  PoseSource --Intake (checks, time stamp)--> filters --> listener, NewestPose --boresight--> read
 *                 |                                             (thread of the tracker)   (any thread)
 *                 +--> HealthMeter
 * </pre>
 *
 * <p>The newest pose lies in a sequence lock. Nothing is allocated per record. Uses {@code tracker}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.live;

import org.jspecify.annotations.NullMarked;
