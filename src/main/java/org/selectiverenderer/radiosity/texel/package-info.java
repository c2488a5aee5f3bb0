/**
 * Light at texels: what falls on each place that an {@link
 * org.selectiverenderer.radiosity.atlas.Atlas} has a texel for.
 *
 * <p>In: a scene, the solution on its patches, an atlas. Light from lamps is found at every texel,
 * light from surfaces where it changes and in between by planes through several places, which evens
 * out their noise and leaves what the surface's shape and the shadows' edges make; what noise is
 * left is told, and where it is more than is wished for there are more rays. A wall between two
 * places keeps them apart, however thin it is, as the rays from each tell it. The texels of an
 * object's other versions take the light of the nearest place of the version that stands for it, so
 * that all versions are lit alike. Of what is seen from both sides {@link
 * org.selectiverenderer.radiosity.texel.SeenSides} says which one is lit, at vertices too. Out:
 * {@link org.selectiverenderer.radiosity.texel.LightPages}. Uses {@code radiosity.atlas}, {@code
 * radiosity.light}, {@code radiosity.sampling}, {@code radiosity.scene}, {@code radiosity.solve},
 * {@code radiosity.trace}, {@code radiosity.work}, {@code geometry} and {@code geometry.tree}.
 */
@NullMarked
package org.selectiverenderer.radiosity.texel;

import org.jspecify.annotations.NullMarked;
