/**
 * A participant's session, without a user interface: steps, journal, assignment of conditions,
 * status and collected answers of a study.
 *
 * <p>The journal, {@code events.jsonl}, is the only state of a session (event sourcing). One
 * program at a time writes it ({@link org.selectiverenderer.study.session.SessionLock}), and keeps
 * its contents in memory. All events are on the disk before the next step begins; nothing is ever
 * overwritten. The end of a step is logged once the step's head log is complete and forced to the
 * disk, so a session is resumed by reading the journal and doing the unfinished steps. Quality
 * flags mark sessions whose answers may not count. BIDS files are converted from head logs in the
 * background; the tables of answers are built from the journal at the end.
 *
 * <p>In: a study with its questionnaires ({@link org.selectiverenderer.study.session.LoadedStudy}),
 * and the begin and end of each step, with its answers. Out: {@code sub-ID/ses-NN/} in the study's
 * folder, {@code participants.tsv}, status and collected answers.
 *
 * <p>Uses {@code study.definition}, {@code study.questionnaire}, {@code study.headlog}, {@code
 * schema} for conditions and the bands of ratings, {@code tracker} for the tracker's SPEC, and
 * {@code base}. No GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.session;

import org.jspecify.annotations.NullMarked;
