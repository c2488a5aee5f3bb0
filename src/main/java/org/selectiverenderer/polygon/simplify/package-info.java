/**
 * Fewer polygons for a model, with as little change to see as possible.
 *
 * <p>In: the meshes of a model's parts, and a goal. Out: meshes of the same parts, and how far they
 * are from the original. Uses {@code x3d.geometry} and LWJGL's meshoptimizer. Nothing is kept
 * between calls: several threads may reduce several models, and each gives the same result every
 * time.
 */
@NullMarked
package org.selectiverenderer.polygon.simplify;

import org.jspecify.annotations.NullMarked;
