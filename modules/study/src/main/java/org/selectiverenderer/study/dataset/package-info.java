/**
 * The recorded data of a study, read from its folder and laid out in documented tables, which the
 * BIDS dataset and the exported tables share.
 *
 * <p>In: a study's folder as sessions have left it: {@code participants.tsv}, and of each session
 * the journal, the head logs and the tables of answers. A part that a crash has damaged is reported
 * with its file and line; the rest is used. Out: a {@link
 * org.selectiverenderer.study.dataset.RecordedStudy} of sessions and runs, and {@link
 * org.selectiverenderer.study.dataset.DataTable}s of them with documented columns.
 *
 * <pre>
 *   folder -> RecordedStudy -> RecordedSession -> RecordedRun -> tables -> study.bids, study.export
 * </pre>
 *
 * <p>A table is built in one place, so that a column means the same in BIDS and in the exported
 * files. Nothing is ever written to the study's folder, and no table contains answers that a
 * questionnaire marks as personal. Uses {@code study.session} for the layout of the folder and the
 * questionnaires, {@code study.questionnaire} for answers, {@code study.headlog} for what was
 * looked at, {@code study.definition} and {@code base}; no GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.dataset;

import org.jspecify.annotations.NullMarked;
