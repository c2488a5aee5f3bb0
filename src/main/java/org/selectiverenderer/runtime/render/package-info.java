/**
 * The JOGL renderer: draws an instance tree as one or several cameras see it. OpenGL 3.3, core
 * profile. This package holds what its parts speak of.
 *
 * <p>A frame is drawn as a {@link org.selectiverenderer.runtime.camera.ViewLayout} says: one or
 * several cameras of one update of the world, culled once for all of them. Every way of showing two
 * eyes is a layout: side by side, two colours, two buffers. For two monitors both eyes are drawn
 * side by side into one frame buffer; the main window shows its left half, a copy of the right half
 * goes to the other window through memory, since screens of an X server share no textures. The
 * operator's window gets a copy too, ten times a second. All windows are drawn, then all are shown,
 * each with its own context current: Mesa's software renderer else shows pictures that are still
 * being filled.
 *
 * <p>Sub-packages: {@code light} where light is computed, {@code mesh} meshes made ready and {@code
 * occlude} what is hidden and need not be drawn, {@code glsl} programs of authors as texts, all
 * without GL; {@code gpu} what lives on the graphics card; {@code context} finding out about GL,
 * drawing without a window; {@code window} the window, its loop and its input, and windows beside
 * it; {@code sketch} flat drawings; {@code draw} a scene as one camera sees it; {@code mark} the
 * same with marks, for an editor; {@code show} a world in its windows or without one.
 *
 * <p>In: an {@link org.selectiverenderer.runtime.instance.InstanceTree}, {@link
 * org.selectiverenderer.runtime.camera.Camera}s, a backdrop. Out: pixels in the current frame
 * buffer. Everything that takes a {@code GL3} belongs to the one thread that owns the context. Uses
 * {@code runtime} but {@code runtime.sai} and {@code runtime.loading}, {@code geometry}, {@code
 * x3d.catalogue}, {@code x3d.field}, {@code x3d.shader}, {@code base.picture}, {@code base.problem}
 * and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.runtime.render;

import org.jspecify.annotations.NullMarked;
