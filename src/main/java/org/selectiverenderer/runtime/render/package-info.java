/**
 * The JOGL renderer: draws an instance tree as one or several cameras see it ({@link
 * org.selectiverenderer.runtime.render.ViewLayout}). OpenGL 3.3, core profile.
 *
 * <p>In: an {@link org.selectiverenderer.runtime.instance.InstanceTree}, a {@link
 * org.selectiverenderer.runtime.render.Camera}, a backdrop. Out: pixels in the current frame
 * buffer. Everything that takes a {@code GL3} belongs to the one thread that owns the context.
 *
 * <p>Sub-packages: {@code mesh} meshes made ready, without GL; {@code gpu} what lives on the
 * graphics card; {@code context} finding out about GL, drawing without a window; {@code window} the
 * window, its loop and its input, and windows beside it; {@code sketch} flat drawings. Uses {@code
 * instance}, {@code navigation}, {@code x3d.geometry}.
 */
@NullMarked
package org.selectiverenderer.runtime.render;

import org.jspecify.annotations.NullMarked;
