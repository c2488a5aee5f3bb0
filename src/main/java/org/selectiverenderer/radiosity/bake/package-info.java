/**
 * Light at the vertices, and how it becomes colours.
 *
 * <p>In: facets and the solution on patches. Out: irradiance per vertex, and display colours by a
 * tone curve. Uses {@code radiosity.mesh}, {@code radiosity.sampling}, {@code radiosity.scene},
 * {@code radiosity.solve}, {@code radiosity.trace}, {@code radiosity.work} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.radiosity.bake;

import org.jspecify.annotations.NullMarked;
