/**
 * Surfaces of triangles: one immutable mesh, what builds it, what measures it, what divides it and
 * what puts it elsewhere.
 *
 * <p>In: points and triangles. Out: meshes. Triangles go counter-clockwise seen from outside. The
 * same call gives the same bits on every machine. Uses {@code geometry} only.
 */
@NullMarked
package org.selectiverenderer.geometry.mesh;

import org.jspecify.annotations.NullMarked;
