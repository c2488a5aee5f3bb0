/**
 * The bundled fonts: reads TrueType outlines and triangulates them.
 *
 * <p>In: the {@code .ttf} files beside this package (see the README there) and code points. Out:
 * {@link org.selectiverenderer.geometry.font.Glyph}s in ems and metrics. Uses {@code geometry}, and
 * earcut4j, which triangulates outlines; no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.geometry.font;

import org.jspecify.annotations.NullMarked;
