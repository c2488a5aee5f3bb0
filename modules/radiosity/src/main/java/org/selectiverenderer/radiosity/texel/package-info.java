/**
 * The irradiance at texels: at each surface point that an {@link
 * org.selectiverenderer.radiosity.atlas.Atlas} has a texel for.
 *
 * <p>In: a scene, the solution on its patches, an atlas. Direct light is computed at every texel.
 * Indirect light is sampled at irradiance records, which are densest where it changes, and
 * interpolated in between by local planes, which reduces noise and keeps the gradients of the
 * surface's shape and of shadow edges; the remaining noise is estimated, and records with more
 * noise than requested get more rays. A wall between two points separates them, however thin it is,
 * as the rays from each tell. The texels of an object's other versions take the light of the
 * closest point of its reference version, so that all versions are lit alike. For two-sided
 * surfaces {@link org.selectiverenderer.radiosity.texel.TwoSidedLightSelector} selects the lit
 * side, at vertices too. Out: {@link org.selectiverenderer.radiosity.texel.IrradianceAtlas}. Uses
 * {@code radiosity.atlas}, {@code radiosity.light}, {@code radiosity.sampling}, {@code
 * radiosity.scene}, {@code radiosity.solve}, {@code radiosity.trace}, {@code radiosity.parallel},
 * {@code geometry} and {@code geometry.bvh}.
 */
@NullMarked
package org.selectiverenderer.radiosity.texel;

import org.jspecify.annotations.NullMarked;
