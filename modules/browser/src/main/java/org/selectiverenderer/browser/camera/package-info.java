/**
 * The cameras and views of a frame, and two-dimensional primitives drawn over them; without GL.
 *
 * <p>In: a world and its viewer. Out: {@link org.selectiverenderer.browser.camera.ViewLayout}s,
 * which any display mode may implement and the renderer draws. Uses {@code browser}, {@code
 * browser.instance} and {@code browser.viewer}, but no renderer.
 */
@NullMarked
package org.selectiverenderer.browser.camera;

import org.jspecify.annotations.NullMarked;
