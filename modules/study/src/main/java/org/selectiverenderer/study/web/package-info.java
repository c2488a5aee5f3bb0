/**
 * Sessions that ran in participants' web browsers, made into session folders as this program's own
 * sessions leave them, so that all else of the program reads both alike.
 *
 * <p>In: the records of the page (docs/web-study.md), as files of the receiver, of participants who
 * saved them, or as result data of JATOS; a study. They come from strangers: sizes are bounded, and
 * what is not as the page writes it is reported with file and line and left out. Out: {@code
 * sub-webNNN/ses-01} in the study's folder, rows of {@code participants.tsv}. Records are kept in
 * the session's folder, so that what comes later is put to them.
 *
 * <p>{@link org.selectiverenderer.study.web.WebSessionImport} does it: {@code WebRecordIndex} finds
 * which line belongs to which session, {@code WebRecordParser} checks a record, {@code
 * WebSessionEvents} tells it as events of a journal, trials of blocks among them. {@code
 * WebTrialPlan} refuses trials that no plan has, {@code StimulusRows} finds what they showed. What
 * was in view is not in the records; an {@link org.selectiverenderer.study.web.ExposureReplay}
 * finds it in the scene.
 *
 * <p>Uses {@code study.session}, {@code study.questionnaire}, {@code study.headlog}, {@code
 * study.definition}, {@code study.design}, {@code formats} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.study.web;

import org.jspecify.annotations.NullMarked;
