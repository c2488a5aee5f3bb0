/**
 * Computational geometry shared by all packages: triangles and normals, bounding boxes, angles.
 *
 * <p>In: coordinates as primitive arrays. Out: numbers and small records. This package knows
 * nothing of X3D, files or displays and uses no other package of ours. Its subpackages are {@code
 * mesh}, {@code convex}, {@code tree}, {@code font}, {@code nurbs}, {@code geo} and {@code
 * tessellate}; the last two know X3D. Computations for generated files are bit-identical on every
 * machine.
 */
@NullMarked
package org.selectiverenderer.geometry;

import org.jspecify.annotations.NullMarked;
