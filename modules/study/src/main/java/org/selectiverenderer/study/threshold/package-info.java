/**
 * The threshold pilot (thesis 4.2.1), without a user interface: it measures the number of polygons
 * below which people notice the simplification of an object, or no longer recognise it. Two tasks,
 * {@link org.selectiverenderer.study.threshold.ThresholdTask}:
 *
 * <ul>
 *   <li>{@code tell-apart}: the original in the middle; beside it, left and right, the original
 *       again and a version. Which one differs? A staircase per object estimates the number of
 *       polygons from which people see no difference.
 *   <li>{@code recognise}: a version alone and four names. The series of an object begins with the
 *       fewest polygons and goes up until the object is named. It never goes down again, as a
 *       participant who has recognised an object once would recognise it with fewer polygons, too.
 * </ul>
 *
 * <p>The data flow:
 *
 * <pre>
 *  threshold.json, read by {@code ThresholdStudyReader}: ThresholdStudy
 *  + versions of each object: {@code StimulusLevels}
 *  + answers so far in sub-ID/trials.jsonl: TrialLog
 *    --> {@code InterleavedTracks} --next--> ThresholdTrial
 *    --> response by window or SimulatedObserver --> TrialLog
 *  TrialLog of all participants --> ThresholdResults --> table, versions commands
 * </pre>
 *
 * <p>The log is the only state. The next trial is determined by the settings, the participant's id
 * and the answers so far, so an interrupted session continues with the trial that would have been
 * next. One thread at a time.
 *
 * <p>Uses {@code statistics.distribution}, {@code study.session} for the lock and the recovery of
 * journals, and {@code base}. No GL, no AWT: {@code app.threshold} makes the pictures, {@code
 * app.window} shows them.
 */
@NullMarked
package org.selectiverenderer.study.threshold;

import org.jspecify.annotations.NullMarked;
