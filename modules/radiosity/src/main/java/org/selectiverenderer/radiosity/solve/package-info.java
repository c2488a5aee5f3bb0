/**
 * The radiosity solution on patches: the surfaces are divided into patches, form factors between
 * them are sampled by rays, and the radiosity equation is iterated until the requested share of the
 * energy is distributed.
 *
 * <p>In: a {@link org.selectiverenderer.radiosity.scene.RadiosityScene}. Out: the radiance of each
 * patch, with an {@link org.selectiverenderer.radiosity.solve.EnergyBalance} per iteration. Uses
 * {@code radiosity.light}, {@code radiosity.sampling}, {@code radiosity.scene}, {@code
 * radiosity.trace} and {@code radiosity.parallel}.
 */
@NullMarked
package org.selectiverenderer.radiosity.solve;

import org.jspecify.annotations.NullMarked;
