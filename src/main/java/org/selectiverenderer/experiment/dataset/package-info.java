/**
 * What was recorded of a study, read back from its folder and laid out in tables: the vocabulary of
 * those who hand it on.
 *
 * <p>In: a study's folder as sessions have left it: {@code participants.tsv}, and of each session
 * the journal, the head logs and the tables of answers. Whatever a crash has damaged is a problem
 * with its place; the rest is used. Out: a {@link
 * org.selectiverenderer.experiment.dataset.RecordedStudy} of sessions and runs, and {@link
 * org.selectiverenderer.experiment.dataset.DataTable}s of them, whose columns say what they mean.
 *
 * <pre>
 *   folder -> RecordedStudy -> RecordedSession -> RecordedRun -> tables -> experiment.bids, experiment.export
 * </pre>
 *
 * <p>A table is made in one place, so that a column means the same in BIDS and in the exported
 * files. Nothing is ever written into the study's folder, and what a questionnaire calls personal
 * leaves it in no table. Uses {@code experiment.session} for where things are and what was asked,
 * {@code experiment.questionnaire} for answers, {@code experiment.headlog} for what was looked at,
 * {@code experiment.study} and {@code base}; no GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.dataset;

import org.jspecify.annotations.NullMarked;
