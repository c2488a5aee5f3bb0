/**
 * Baking: irradiance at the vertices, and tone mapping of light to vertex colours and lightmap
 * images.
 *
 * <p>In: facets and the solution on patches. Out: irradiance per vertex, and display colours by a
 * tone mapping. In: pages of irradiance at texels and the textures of the surfaces. Out: lightmap
 * images. Uses {@code radiosity.atlas}, {@code radiosity.mesh}, {@code radiosity.sampling}, {@code
 * radiosity.scene}, {@code radiosity.solve}, {@code radiosity.texel}, {@code radiosity.trace},
 * {@code radiosity.parallel}, {@code browser} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.radiosity.bake;

import org.jspecify.annotations.NullMarked;
