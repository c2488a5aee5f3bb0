/**
 * Shows a world in a headset, whose runtime decides when frames are due and provides the textures
 * that they are drawn into, and mirrors it to windows on the desktop.
 *
 * <p>Two threads that never wait for each other:
 *
 * <pre>
 *   headset: runtime's pace -> WorldController.step -> both eyes -> runtime's textures
 *                 ^ input (queue)                   | every 33 ms, by a pixel buffer that is read
 *                 |                                 v when the graphics card is done with it
 *   render:  windows' input  &lt;- mirror, operator's window, at the desktop's pace
 * </pre>
 *
 * <p>The thread {@code headset} has a context of its own without a window ({@link
 * org.selectiverenderer.render.headset.HeadsetContext}), with which a runtime may share textures:
 * it needs a surface with an X visual, which JOGL's usual context without a window does not have.
 * It steps the world, draws, and makes all calls of {@link
 * org.selectiverenderer.render.display.WorldController} and of the {@link
 * org.selectiverenderer.render.headset.HeadsetDisplay}. The thread {@code render} shows the newest
 * of what was published ({@link org.selectiverenderer.render.headset.MirrorReadback}).
 *
 * <p>In: a {@link org.selectiverenderer.render.display.WorldController} and a {@link
 * org.selectiverenderer.render.headset.HeadsetDisplay}, which another module implements for a
 * runtime: this package does not depend on OpenXR. Uses {@code render.display}, {@code
 * render.window}, {@code render.context}, {@code render.graphics2d}, {@code browser.camera} and
 * {@code browser}.
 */
@NullMarked
package org.selectiverenderer.render.headset;

import org.jspecify.annotations.NullMarked;
