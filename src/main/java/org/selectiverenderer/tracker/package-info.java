/**
 * Head trackers: where the head looks, whatever device says so.
 *
 * <p>In: what a user writes as the SPEC of a tracker ({@link
 * org.selectiverenderer.tracker.TrackerSpec}) and how its axes are to be read ({@link
 * org.selectiverenderer.tracker.TrackerOptions}). Out: a {@link
 * org.selectiverenderer.tracker.HeadTracker}, whose newest pose is read at the moment of drawing;
 * problems as sentences, each once.
 *
 * <p>{@link org.selectiverenderer.tracker.Trackers} opens all of them. To add one: a record in
 * {@code TrackerSpec}, a {@link org.selectiverenderer.tracker.pose.PoseSource} in a sub-package
 * beside the others, a line in {@code Trackers}.
 *
 * <ul>
 *   <li>{@code pose}: the way of a record from its arrival to the reader, the same for all
 *   <li>{@code serial}, {@code net}, {@code replay}: the devices' protocols
 *   <li>{@code emulate}: a device to try all this without one
 *   <li>{@code report}: what the command {@code track} shows and writes
 * </ul>
 *
 * <p>Uses {@code x3d} for problems and {@code csv} for tables; no scene, no window, no GL.
 */
@NullMarked
package org.selectiverenderer.tracker;

import org.jspecify.annotations.NullMarked;
