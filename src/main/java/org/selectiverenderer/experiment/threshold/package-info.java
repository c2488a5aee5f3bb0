/**
 * The threshold pilot (thesis 4.2.1), without windows: with how few polygons is an object still
 * what it was? Two tasks, {@link org.selectiverenderer.experiment.threshold.ThresholdTask}:
 *
 * <ul>
 *   <li>{@code tell-apart}: the original above; below, left and right, the original again and a
 *       version. Which one differs? A staircase per object looks for the polygons at which people
 *       begin to see no difference.
 *   <li>{@code recognise}: a version alone and four names. The series of an object begins with the
 *       fewest polygons and goes up until the object is named: who has recognised it once would
 *       recognise it with fewer polygons too, so nobody is ever shown fewer again.
 * </ul>
 *
 * <p>The data flow:
 *
 * <pre>
 *  threshold.json --ThresholdReader--> ThresholdStudy --+
 *  polygons of each object's versions, PolygonLadder ---+--> ThresholdPilot --next--> ThresholdTrial
 *                                                       |         ^                        |
 *  sub-ID/trials.jsonl --TrialLog-- answers so far -----+         +------- response -------+
 *                            |                                    (window or SimulatedObserver)
 *                            +--> ThresholdResults --> table, versions commands
 * </pre>
 *
 * <p>What has happened is what the log says; nothing else is state. The next trial follows from the
 * settings, the participant's id and the answers so far, and from nothing else, so a session that
 * was cut off goes on with the very trial that it would have come to. One thread at a time.
 *
 * <p>Uses {@code statistics.distribution}, {@code experiment.session} for how a journal is locked
 * and mended, and {@code base}. No GL, no AWT: {@code app.threshold} makes the pictures, {@code
 * experiment.window} shows them.
 */
@NullMarked
package org.selectiverenderer.experiment.threshold;

import org.jspecify.annotations.NullMarked;
