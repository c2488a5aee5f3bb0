/**
 * The cameras and views of a frame, and two-dimensional primitives drawn over them; without GL.
 *
 * <p>In: a world and its viewer. Out: {@link org.selectiverenderer.runtime.camera.ViewLayout}s,
 * which any display mode may implement and the renderer draws. Uses {@code runtime}, {@code
 * runtime.instance} and {@code runtime.viewer}, but no renderer.
 */
@NullMarked
package org.selectiverenderer.runtime.camera;

import org.jspecify.annotations.NullMarked;
