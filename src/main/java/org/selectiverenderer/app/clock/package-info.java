/**
 * The timing of a run: frame clocks, frame schedules and the choice between real time and as fast
 * as possible. A run along a path has the same frames in both cases.
 *
 * <p>In: the settings of a run and the elapsed time. Out: the times of frames. Uses {@code
 * app.settings}, {@code walkthrough}, {@code browser} and {@code browser.viewer}.
 */
@NullMarked
package org.selectiverenderer.app.clock;

import org.jspecify.annotations.NullMarked;
