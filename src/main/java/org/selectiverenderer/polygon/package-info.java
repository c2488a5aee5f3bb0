/**
 * The polygon count process (thesis 4.2): reads and simplifies models, and counts polygons; {@code
 * document.versions} puts simplified models into a scene. A polygon is a triangle.
 *
 * <p>Within: {@code simplify} makes meshes with fewer polygons, {@code model} reads and writes
 * models, {@code count} counts the polygons of a scene. They use {@code chart}, {@code schema},
 * {@code geometry}, {@code x3d}, {@code base} and LWJGL's meshoptimizer and Assimp, no AWT and no
 * GL.
 */
@NullMarked
package org.selectiverenderer.polygon;

import org.jspecify.annotations.NullMarked;
