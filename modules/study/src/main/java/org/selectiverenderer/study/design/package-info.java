/**
 * The experimental design of a study: its factors, the blocks of trials, and the order in which
 * each participant sees them.
 *
 * <p>A <em>factor</em> varies <em>between</em> participants, who each have one of its levels, or
 * <em>within</em> participants, who have all of them. A level sets what a trial shows ({@link
 * org.selectiverenderer.study.design.TrialSettings}): condition, choices of Switches, scene, area,
 * viewpoint, duration, light, display. The combinations of the levels of the between factors are
 * the <em>groups</em> ({@link org.selectiverenderer.study.design.StudyGroup}); a study without
 * factors has a group for each of its conditions.
 *
 * <p>A <em>block</em> ({@link org.selectiverenderer.study.design.TrialBlock}) crosses the levels of
 * its within factors with the rows of its stimulus list and its repetitions. Each product is a
 * <em>trial</em> ({@link org.selectiverenderer.study.design.Trial}), which loads one scene and goes
 * through the <em>phases</em> of the block ({@link org.selectiverenderer.study.design.TrialPhase}):
 * instruction, fixation, exposure, blank, questions, feedback.
 *
 * <p>The order of the trials depends on the study's seed, the block, and the participant's place
 * alone ({@link org.selectiverenderer.study.design.TrialSequencer}), so that it can be shown before
 * anybody comes, and is the same at every call and on every machine. A block with a staircase
 * chooses each trial by the answers before it.
 *
 * <p>In: a study file's keys {@code factors} and {@code blocks}, read by {@code study.definition},
 * and stimulus lists (CSV). Out: the groups, and the trials of a participant, which {@code
 * study.session} goes through. Uses {@code schema} for conditions, {@code apparatus} for display
 * modes, {@code formats} for tables, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.design;

import org.jspecify.annotations.NullMarked;
