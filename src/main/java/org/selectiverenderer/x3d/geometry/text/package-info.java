/**
 * The program's fonts: outlines of TrueType files as triangles.
 *
 * <p>In: the {@code .ttf} files beside this package (see the README there) and code points. Out:
 * {@link org.selectiverenderer.x3d.geometry.text.Glyph}s in ems and metrics. Uses nothing of the
 * other packages, no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.x3d.geometry.text;

import org.jspecify.annotations.NullMarked;
