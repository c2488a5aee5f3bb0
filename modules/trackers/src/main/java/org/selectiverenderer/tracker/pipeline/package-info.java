/**
 * The pipeline of a record from its arrival to the renderer, the same for every tracker.
 *
 * <p>In: a {@link org.selectiverenderer.tracker.pipeline.PoseSource}, which implements one
 * protocol, and filters for {@link org.selectiverenderer.tracker.TrackerOptions}. Out: a {@link
 * org.selectiverenderer.tracker.pipeline.LiveTracker} with its thread, the {@link
 * org.selectiverenderer.tracker.pipeline.LatestPose}, statistics, and problems, each reported once.
 *
 * <pre>
 *  PoseSource --records--> PoseSink (checks, time stamps) --> filters --> TrackerHealthMonitor
 *    --> listener, on the tracker's thread
 *    --> {@code LatestPose} --boresight--> read, on any thread
 * </pre>
 *
 * <p>A sequence lock guards the latest pose. Nothing is allocated per record. Uses {@code tracker}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.tracker.pipeline;

import org.jspecify.annotations.NullMarked;
