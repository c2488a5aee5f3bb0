/**
 * The polygon count process (thesis 4.2): models read and reduced, polygons counted; {@code
 * document.versions} puts reduced models into a scene. A polygon is a triangle.
 *
 * <p>Within: {@code simplify} makes meshes with fewer polygons, {@code model} reads and writes
 * models, {@code statistics} counts what a scene has. They use {@code chart}, {@code schema},
 * {@code geometry}, {@code x3d}, {@code base} and LWJGL's meshoptimizer and Assimp, no AWT and no
 * GL.
 */
@NullMarked
package org.selectiverenderer.polygon;

import org.jspecify.annotations.NullMarked;
