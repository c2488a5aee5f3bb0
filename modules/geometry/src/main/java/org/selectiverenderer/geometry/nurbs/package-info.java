/**
 * Non-uniform rational B-splines: bases, curves and surfaces, evaluated with their derivatives (L.
 * Piegl and W. Tiller, The NURBS Book, 2nd edition, 1997).
 *
 * <p>In: knots, control points, weights. Out: points and derivatives in the control points' space.
 * Control points are homogeneous, as in X3D 4.0, 27.4: the Euclidean point is the given point
 * divided by its weight. Uses nothing.
 */
@NullMarked
package org.selectiverenderer.geometry.nurbs;

import org.jspecify.annotations.NullMarked;
