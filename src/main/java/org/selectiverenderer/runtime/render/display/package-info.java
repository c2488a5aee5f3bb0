/**
 * Shows a world: in a window, with an operator's window beside it, or without a window.
 *
 * <p>In: a {@link org.selectiverenderer.runtime.render.display.WorldHost}, which steps the world
 * and provides overlays. Out: frames on the screen or as images, each drawn by {@code
 * runtime.render.draw}; the view ray of the pointing device. Uses all other packages of the
 * renderer but {@code mark}, {@code runtime}, {@code runtime.camera}, {@code runtime.viewer} and
 * {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.display;

import org.jspecify.annotations.NullMarked;
