/**
 * The X3D language: node catalogue (data), field types, reading {@code .x3d} and {@code .x3dz}.
 *
 * <p>In: bytes of a file. Out: {@link org.selectiverenderer.x3d.X3dFile} and problems with their
 * places. Uses nothing of the other packages, no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.x3d;

import org.jspecify.annotations.NullMarked;
