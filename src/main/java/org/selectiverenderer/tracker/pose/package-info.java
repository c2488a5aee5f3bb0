/**
 * The way of a record from its arrival to whoever draws, the same for every tracker.
 *
 * <p>In: a {@link org.selectiverenderer.tracker.pose.PoseSource}, which knows one protocol, and
 * filters for {@link org.selectiverenderer.tracker.TrackerOptions}. Out: a {@link
 * org.selectiverenderer.tracker.pose.LiveTracker} with its thread, the {@link
 * org.selectiverenderer.tracker.pose.NewestPose}, health, and problems said once.
 *
 * <pre>
 *  PoseSource --Intake (checks, time stamp)--> filters --> listener, NewestPose --boresight--> read
 *                 |                                             (thread of the tracker)   (any thread)
 *                 +--> HealthMeter
 * </pre>
 *
 * <p>Nothing is allocated per record. Uses the interface types of {@code tracker} only.
 */
@NullMarked
package org.selectiverenderer.tracker.pose;

import org.jspecify.annotations.NullMarked;
