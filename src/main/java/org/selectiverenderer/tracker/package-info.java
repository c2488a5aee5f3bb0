/**
 * Head trackers: where the head looks, whatever device says so. A tracker knows no scene and is
 * driven by none.
 *
 * <p>A tracker has a thread; a record comes when the device sends it, and whoever draws reads the
 * newest at that moment; neither waits for the other. Angles are plain numbers in objects that are
 * used again; {@link org.selectiverenderer.tracker.Orientation}, by the rotations of Commons Math,
 * is the definition that a test holds this fast path to. A recording that must give the same frames
 * again is stepped by the frames' clock, not by the wall's.
 *
 * <p>{@link org.selectiverenderer.tracker.open.Trackers} opens all of them. To add one:
 *
 * <ol>
 *   <li>a record in {@link org.selectiverenderer.tracker.TrackerSpec}, and how it is written in
 *       {@code TrackerSpecParser} (the switch, and the list of kinds)
 *   <li>a {@link org.selectiverenderer.tracker.live.PoseSource} in {@code serial} or {@code net},
 *       beside the others, with its test
 *   <li>a line in {@code Trackers}
 *   <li>what may be wrong with a sender that is not understood: {@code live.TroubleEpisodes}
 *   <li>the help of {@code --tracker} and of {@code track} in {@code cli.view}, and
 *       docs/trackers.md
 * </ol>
 *
 * <p>The packages inside:
 *
 * <ul>
 *   <li>{@code live}: the way of a record from its arrival to the reader, the same for all
 *   <li>{@code serial}, {@code net}, {@code replay}: the devices' protocols; {@code text} is what
 *       those that send lines share
 *   <li>{@code open}: opens all of them
 *   <li>{@code emulate}: a device to try all this without one
 *   <li>{@code report}: what the command {@code track} shows and writes
 * </ul>
 *
 * <p>In: what a user writes as the SPEC of a tracker ({@link
 * org.selectiverenderer.tracker.TrackerSpec}) and how its axes are to be read ({@link
 * org.selectiverenderer.tracker.TrackerOptions}). Out: a {@link
 * org.selectiverenderer.tracker.HeadTracker}, whose newest pose is read at the moment of drawing;
 * problems as sentences, each once. This package holds what all of its sub-packages speak of, and
 * uses none of them: {@code base.problem} and Commons Math only; no scene, no window, no GL.
 */
@NullMarked
package org.selectiverenderer.tracker;

import org.jspecify.annotations.NullMarked;
