/**
 * Mesh simplification: fewer polygons for a model, all parts together, with as little visible
 * change as possible.
 *
 * <p>In: the meshes of a model's parts, and a target. Out: meshes of the same parts, and how far
 * they are from the original. No state is kept between calls: several threads may simplify several
 * models, and the same input gives the same result. Uses {@code geometry}, {@code geometry.mesh}
 * and LWJGL's meshoptimizer.
 */
@NullMarked
package org.selectiverenderer.models.simplify;

import org.jspecify.annotations.NullMarked;
