/**
 * Light at the vertices, and how light becomes colours there and in pictures.
 *
 * <p>In: facets and the solution on patches. Out: irradiance per vertex, and display colours by a
 * tone curve. In: pages of light at texels and what lies on the surfaces. Out: pictures. Uses
 * {@code radiosity.atlas}, {@code radiosity.mesh}, {@code radiosity.sampling}, {@code
 * radiosity.scene}, {@code radiosity.solve}, {@code radiosity.texel}, {@code radiosity.trace},
 * {@code radiosity.work}, {@code runtime} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.radiosity.bake;

import org.jspecify.annotations.NullMarked;
