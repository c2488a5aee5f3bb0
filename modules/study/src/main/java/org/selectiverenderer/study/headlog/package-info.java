/**
 * The head log of a session (thesis 6.1.4): for each frame the pose of the head, the object in the
 * middle of the view and its version; and the analysis of such logs.
 *
 * <p>In: the running world of a session; or the files of a log. Out: a CSV with a JSON description
 * beside it, written while the session runs by a thread of its own; Motion-BIDS files; dwells and
 * fixations, the share of each room that was seen, plots. {@link
 * org.selectiverenderer.study.headlog.HeadLogWriter} writes, {@link
 * org.selectiverenderer.study.headlog.HeadLogReader} reads, {@link
 * org.selectiverenderer.study.headlog.HeadLogAnalysis} analyses a log that was read.
 *
 * <p>Uses {@code browser} and {@code x3d.catalogue} for the scene, and {@code base}; no GL, no AWT.
 */
@NullMarked
package org.selectiverenderer.study.headlog;

import org.jspecify.annotations.NullMarked;
