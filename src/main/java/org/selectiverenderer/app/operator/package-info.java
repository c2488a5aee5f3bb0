/**
 * Status text over the picture and beside it: the user's overlay, and the content of the operator's
 * window in a session.
 *
 * <p>In: a walk, its head and its figures. Out: lines and {@link
 * org.selectiverenderer.browser.camera.Primitive2D}s to be drawn. Uses {@code app.head}, {@code
 * app.settings}, {@code walkthrough}, {@code study.headlog} for the map, {@code hmd}, {@code
 * tracker} and {@code browser}.
 */
@NullMarked
package org.selectiverenderer.app.operator;

import org.jspecify.annotations.NullMarked;
