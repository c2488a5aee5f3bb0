/**
 * Runs the threshold pilot: makes the versions of its objects and pictures of them, and shows
 * trials until all thresholds are found.
 *
 * <p>In: {@link org.selectiverenderer.study.threshold.ThresholdStudy}. The pictures are made once,
 * before the first participant, by {@code authoring.versions} and the renderer, on the caller's
 * thread, and kept in {@code threshold/pictures} with a checksum of their inputs, so that all
 * participants see the same ones. Out: answers, passed to a {@link
 * org.selectiverenderer.study.threshold.ThresholdSession}.
 */
@NullMarked
package org.selectiverenderer.app.threshold;

import org.jspecify.annotations.NullMarked;
