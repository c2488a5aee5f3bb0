/**
 * Shows a world: in a window, with an operator's window beside it, or without a window.
 *
 * <p>In: a {@link org.selectiverenderer.render.display.WorldController}, which steps the world and
 * provides overlays. Out: frames on the screen or as images, each drawn by {@code render.draw}; the
 * view ray of the pointing device. Uses all other packages of the renderer but {@code mark}, {@code
 * browser}, {@code browser.camera}, {@code browser.viewer} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.render.display;

import org.jspecify.annotations.NullMarked;
