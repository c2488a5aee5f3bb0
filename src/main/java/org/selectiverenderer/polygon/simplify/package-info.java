/**
 * Fewer polygons for a model, all parts together, with as little change to see as possible.
 *
 * <p>In: the meshes of a model's parts, and a goal. Out: meshes of the same parts, and how far they
 * are from the original. Nothing is kept between calls: several threads may reduce several models,
 * and each gives the same result every time. Uses {@code geometry}, {@code geometry.mesh} and
 * LWJGL's meshoptimizer.
 */
@NullMarked
package org.selectiverenderer.polygon.simplify;

import org.jspecify.annotations.NullMarked;
