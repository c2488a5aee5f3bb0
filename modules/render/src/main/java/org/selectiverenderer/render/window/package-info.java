/**
 * Windows with their render loop, which owns the GL context, and their input.
 *
 * <p>In: NEWT's events, from NEWT's own threads. Out: calls of a {@link
 * org.selectiverenderer.render.window.WindowContent} and of an {@link
 * org.selectiverenderer.render.window.InputListener}, all on the render thread. Uses NEWT and
 * {@code render.context}; no AWT.
 */
@NullMarked
package org.selectiverenderer.render.window;

import org.jspecify.annotations.NullMarked;
