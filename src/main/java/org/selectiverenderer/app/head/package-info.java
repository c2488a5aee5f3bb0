/**
 * Head tracking during a run: the tracker, its log and the head log.
 *
 * <p>In: the settings of the head, a walk and its frames. Out: the motion of the viewer, the files
 * of the head log and of the tracker log, the latency from a sample to its picture. Uses {@code
 * app.clock}, {@code app.settings}, {@code walkthrough}, {@code tracker}, {@code hmd}, {@code
 * study.headlog}, {@code study.web}, {@code control}, {@code browser} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.app.head;

import org.jspecify.annotations.NullMarked;
