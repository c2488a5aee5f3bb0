/**
 * The program's fonts: outlines of TrueType files as triangles.
 *
 * <p>In: the {@code .ttf} files beside this package (see the README there) and code points. Out:
 * {@link org.selectiverenderer.geometry.font.Glyph}s in ems and metrics. Uses {@code geometry}, and
 * earcut4j, which divides outlines; no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.geometry.font;

import org.jspecify.annotations.NullMarked;
