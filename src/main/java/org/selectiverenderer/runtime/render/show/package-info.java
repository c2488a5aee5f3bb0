/**
 * Shows a world: in a window and beside it in the operator's, or without a window.
 *
 * <p>In: a {@link org.selectiverenderer.runtime.render.show.WorldHost}, which steps the world and
 * says what is seen. Out: frames on the screen or as images, each drawn by {@code
 * runtime.render.draw}; what the pointing device points at. Uses all other packages of the renderer
 * but {@code mark}, {@code runtime}, {@code runtime.camera}, {@code runtime.viewer} and {@code
 * geometry}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.show;

import org.jspecify.annotations.NullMarked;
