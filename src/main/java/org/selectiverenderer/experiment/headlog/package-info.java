/**
 * The head log of a session (thesis 6.1.4): frame by frame where the head was and looked, what was
 * in the middle of the view and in which version; and what can be read off it afterwards.
 *
 * <p>In: the running world of a session; or the files of a log. Out: a CSV with a JSON description
 * beside it, written while the session runs by a thread of its own; BIDS-motion; looks, how much of
 * each room was seen, plots. {@link org.selectiverenderer.experiment.headlog.HeadLogWriter} writes,
 * {@link org.selectiverenderer.experiment.headlog.HeadLogReader} reads, {@link
 * org.selectiverenderer.experiment.headlog.HeadLogAnalysis} looks at what was read.
 *
 * <p>Uses {@code runtime} and {@code x3d.catalogue} for what is looked at, and {@code base}; no GL,
 * no AWT.
 */
@NullMarked
package org.selectiverenderer.experiment.headlog;

import org.jspecify.annotations.NullMarked;
