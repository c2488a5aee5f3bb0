/**
 * Immutable triangle meshes, and classes that build, weld, measure, refine, copy and transform
 * them.
 *
 * <p>In: points and triangles. Out: meshes. Triangles are wound counter-clockwise seen from
 * outside. Results are bit-identical on every machine. Uses {@code geometry} only.
 */
@NullMarked
package org.selectiverenderer.geometry.mesh;

import org.jspecify.annotations.NullMarked;
