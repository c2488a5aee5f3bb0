/**
 * A study as a BIDS dataset: the Brain Imaging Data Structure (1.11), with its parts Motion (Jeung
 * and others 2024, Motion-BIDS) and Behavioral experiments.
 *
 * <p>In: a {@link org.selectiverenderer.study.dataset.RecordedStudy}. Out: the files of a dataset,
 * all of which are written to a new folder, or none; the study's folder is not changed.
 *
 * <pre>
 *   dataset_description.json  README  participants.tsv, .json
 *   sub-ID/sub-ID_sessions.tsv, .json
 *   sub-ID/ses-NN/sub-ID_ses-NN_scans.tsv, .json
 *   sub-ID/ses-NN/motion/..._task-STEP_tracksys-head_run-NN_motion.tsv, .json, _channels.tsv, .json
 *   sub-ID/ses-NN/motion/..._tracksys-tracker_run-NN_... the same of the tracker's own records
 *   sub-ID/ses-NN/motion/..._task-STEP_run-NN_events.tsv, .json
 *   sub-ID/ses-NN/beh/..._task-STEP_beh.tsv, .json
 * </pre>
 *
 * <p>{@link org.selectiverenderer.study.bids.BidsDataset} assembles the dataset. Uses {@code
 * study.dataset}, {@code study.headlog} for motion data, and {@code base}.
 */
@NullMarked
package org.selectiverenderer.study.bids;

import org.jspecify.annotations.NullMarked;
