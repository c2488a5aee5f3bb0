/**
 * What drives a run: which frames are due when, and what moves the viewer from one to the next. A
 * run of a path has the same frames whether somebody watches it or not.
 *
 * <p>In: the settings of a run and the time that has gone by. Out: the times of frames. Uses {@code
 * app.settings}, {@code app.walk}, {@code runtime} and {@code runtime.viewer}.
 */
@NullMarked
package org.selectiverenderer.app.clock;

import org.jspecify.annotations.NullMarked;
