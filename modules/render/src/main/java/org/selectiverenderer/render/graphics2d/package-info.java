/**
 * Flat graphics in pixels: lines, polygons, text and images on a page whose origin is the upper
 * left corner, y down.
 *
 * <p>In: {@link org.selectiverenderer.browser.camera.Primitive2D}s, which are plain values that any
 * module may make. Out: pixels, by {@link
 * org.selectiverenderer.render.graphics2d.Graphics2dRenderer}, on the thread that owns the context.
 * Letters are drawn as triangles, so that no fonts of the machine are needed. Uses {@code
 * render.gpu}, {@code browser.camera} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.render.graphics2d;

import org.jspecify.annotations.NullMarked;
