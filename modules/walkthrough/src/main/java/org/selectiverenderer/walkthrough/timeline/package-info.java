/**
 * The time line of a walkthrough: the controller's events with their times, and its end.
 *
 * <p>In: {@link org.selectiverenderer.control.ControlEvent}s and the time of their frame. Out: a
 * line for people or a JSON object for programs. Uses {@code control}, {@code base.decimal} and
 * {@code formats.json}.
 */
@NullMarked
package org.selectiverenderer.walkthrough.timeline;

import org.jspecify.annotations.NullMarked;
