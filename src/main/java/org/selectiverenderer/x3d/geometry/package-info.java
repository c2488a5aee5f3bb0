/**
 * Geometry nodes to triangles, lines and points.
 *
 * <p>In: a geometry node of a file or of a running scene. Out: a {@link
 * org.selectiverenderer.x3d.geometry.Mesh}. Uses {@code x3d} only, no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.x3d.geometry;

import org.jspecify.annotations.NullMarked;
