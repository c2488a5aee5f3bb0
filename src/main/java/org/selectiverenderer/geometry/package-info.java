/**
 * The vocabulary of space that all packages share: triangles and their normals, boxes, angles.
 *
 * <p>In: coordinates as primitive arrays. Out: numbers and small values. Nothing here knows of X3D,
 * of files or of a display; it uses no other package of ours. Within: {@code mesh}, {@code convex},
 * {@code tree}, {@code font} and {@code tessellate}, which alone knows X3D. What generated files
 * are computed with gives the same bits on every machine.
 */
@NullMarked
package org.selectiverenderer.geometry;

import org.jspecify.annotations.NullMarked;
