/**
 * A participant's session, without windows: its steps, its journal on disk, who gets which
 * condition, what a study has so far.
 *
 * <p>What has happened in a session is what its journal says, {@code events.jsonl}; nothing else is
 * state. One program at a time adds to it ({@link
 * org.selectiverenderer.experiment.session.SessionLock}), and knows what it says without reading it
 * again. Whatever is told is on disk before the next step; nothing is ever written over. A step's
 * id is in the journal once the step's head log is complete and forced to the disk, so to resume is
 * to read it and do what is left. What sets a session apart is told as flags. BIDS files are made
 * of head logs, in the background; tables of answers are made of the journal at the end.
 *
 * <p>In: a study with its questionnaires ({@link
 * org.selectiverenderer.experiment.session.StudyMaterial}), and what happens, told step by step and
 * answer by answer. Out: {@code sub-ID/ses-NN/} in the study's folder, {@code participants.tsv},
 * status and collected answers.
 *
 * <p>Uses {@code experiment.study}, {@code experiment.questionnaire}, {@code experiment.headlog},
 * {@code control} for conditions, {@code tracker} for which there is, {@code schema} for the bands
 * of ratings, and {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.session;

import org.jspecify.annotations.NullMarked;
