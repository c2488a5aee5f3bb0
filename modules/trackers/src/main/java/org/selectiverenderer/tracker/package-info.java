/**
 * Head trackers of all kinds. A tracker does not depend on the scene.
 *
 * <p>A tracker has a thread that receives records when the device sends them; the renderer reads
 * the latest pose when it draws; neither waits for the other. Angles are plain numbers in reused
 * objects; {@link org.selectiverenderer.tracker.Orientation}, by the rotations of Commons Math, is
 * the reference implementation with which a test compares this fast path. A recording that must
 * reproduce the same frames is stepped by the frames' clock, not by wall-clock time.
 *
 * <p>{@link org.selectiverenderer.tracker.factory.TrackerFactory} opens all of them. To add one:
 *
 * <ol>
 *   <li>a record in {@link org.selectiverenderer.tracker.TrackerSpec}, and how it is written in
 *       {@code TrackerSpecParser} (the switch, and the list of kinds)
 *   <li>a {@link org.selectiverenderer.tracker.pipeline.PoseSource} in {@code serial} or {@code
 *       net}, beside the others, with its test
 *   <li>a line in {@code factory.TrackerFactory}
 *   <li>a hint at what may be wrong with a device whose records are not valid: {@code
 *       pipeline.TrackerProblemReporter}
 *   <li>the help of {@code --tracker} and of {@code track} in {@code cli.view}, and
 *       docs/trackers.md
 * </ol>
 *
 * <p>The packages inside:
 *
 * <ul>
 *   <li>{@code pipeline}: the pipeline of a record from its arrival to the reader, the same for all
 *   <li>{@code serial}, {@code net}, {@code replay}: the devices' protocols; {@code text}: parsers
 *       of text records
 *   <li>{@code factory}: the factory of trackers
 *   <li>{@code emulator}: an emulated device, for tests
 *   <li>{@code report}: the outputs of the command {@code track}
 * </ul>
 *
 * <p>In: the SPEC of a tracker ({@link org.selectiverenderer.tracker.TrackerSpec}) and options for
 * its records ({@link org.selectiverenderer.tracker.TrackerOptions}). Out: a {@link
 * org.selectiverenderer.tracker.HeadTracker}, whose latest pose is read when a frame is drawn;
 * problems as messages, each once. This package contains the types that its sub-packages share, and
 * depends on none of them: {@code base.problem} and Commons Math only; no scene, no window, no GL.
 */
@NullMarked
package org.selectiverenderer.tracker;

import org.jspecify.annotations.NullMarked;
