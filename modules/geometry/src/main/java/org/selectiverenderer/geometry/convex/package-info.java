/**
 * Convex bodies and their intersection test.
 *
 * <p>In: boxes, spheres, cylinders, cones, and convex hulls of points. Out: whether two bodies
 * intersect. A body is defined by its support mapping alone. Uses nothing of ours.
 */
@NullMarked
package org.selectiverenderer.geometry.convex;

import org.jspecify.annotations.NullMarked;
