/**
 * The JOGL renderer: draws an instance tree as one or several cameras see it. OpenGL 3.3, core
 * profile. This package holds the types that its sub-packages share.
 *
 * <p>A frame is drawn as a {@link org.selectiverenderer.browser.camera.ViewLayout} says: one or
 * several cameras of one update of the world, culled once for all of them. Every way of showing two
 * eyes is a layout: side by side, two colours, two buffers. For two monitors both eyes are drawn
 * side by side into one framebuffer; the main window shows its left half, a copy of the right half
 * goes to the other window through memory, since screens of an X server share no textures. The
 * operator's window gets a copy too, ten times a second. All windows are drawn before any buffers
 * are swapped, and each is swapped with its own context current, because Mesa's software renderer
 * otherwise shows pictures that are still being rasterised.
 *
 * <p>Sub-packages without GL: {@code light} refines meshes for per-vertex lighting, {@code mesh}
 * packs meshes into vertex and index buffers, {@code occlude} finds what is hidden behind other
 * things, {@code glsl} translates custom shaders. With GL: {@code gpu} has meshes, textures and
 * shader programs on the graphics card; {@code context} opens GL contexts and offscreen
 * framebuffers; {@code window} has windows with their render loop and input; {@code sketch} draws
 * flat graphics; {@code draw} draws a scene as one camera sees it; {@code mark} draws an editor's
 * preview; {@code show} shows a world in windows or without one; {@code headset} shows it in a
 * headset.
 *
 * <p>In: an {@link org.selectiverenderer.browser.instance.InstanceTree}, {@link
 * org.selectiverenderer.browser.camera.Camera}s, a backdrop. Out: pixels in the current
 * framebuffer. Everything that takes a {@code GL3} belongs to the one thread that owns the context.
 * Uses {@code browser} but {@code browser.sai} and {@code browser.loading}, {@code geometry},
 * {@code x3d.catalogue}, {@code x3d.field}, {@code x3d.shader}, {@code formats.image}, {@code
 * base.problem} and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.render;

import org.jspecify.annotations.NullMarked;
