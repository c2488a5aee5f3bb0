/**
 * The polygon count process (thesis 4.2): models read, reduced, and put into a scene as versions.
 *
 * <p>{@code simplify} makes meshes with fewer polygons, {@code model} reads and writes models,
 * {@code versions} puts a Switch of versions in an object's place. Uses {@code x3d} and LWJGL's
 * meshoptimizer and Assimp, no AWT and no GL. A polygon is a triangle.
 */
@NullMarked
package org.selectiverenderer.polygon;

import org.jspecify.annotations.NullMarked;
