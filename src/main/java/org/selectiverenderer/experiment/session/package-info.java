/**
 * A participant's session, without windows: its steps, its journal on disk, who gets which
 * condition, what a study has so far.
 *
 * <p>In: a study with its questionnaires ({@link
 * org.selectiverenderer.experiment.session.StudyMaterial}), and what happens, told step by step and
 * answer by answer. Out: {@code sub-ID/ses-NN/} in the study's folder, {@code participants.tsv},
 * status and collected answers. Whatever is told is on disk before the next step; nothing is ever
 * written over; what has happened is read back from the journal alone, so a killed session goes on
 * where the journal ends.
 *
 * <p>May use {@code experiment.study}, {@code experiment.questionnaire}, {@code
 * experiment.headlog}, {@code control} for conditions and {@code x3d} for problems. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.session;

import org.jspecify.annotations.NullMarked;
