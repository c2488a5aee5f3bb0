/**
 * Flat drawings in pixels: lines, areas, text, on a page whose origin is the upper left corner, y
 * down.
 *
 * <p>In: {@link org.selectiverenderer.runtime.camera.Mark}s, which are plain values that anything
 * may make. Out: pixels, by {@link org.selectiverenderer.runtime.render.sketch.SketchPainter}, on
 * the thread that owns the context. The letters are triangles, so that no fonts of the machine are
 * needed. Uses {@code runtime.render.gpu}, {@code runtime.camera} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.runtime.render.sketch;

import org.jspecify.annotations.NullMarked;
