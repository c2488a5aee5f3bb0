/**
 * Light at the vertices, and how it becomes colours.
 *
 * <p>In: facets and the solution on patches. Out: irradiance per vertex, and display colours by a
 * tone curve. Uses the other packages of {@code radiosity} but {@code output}.
 */
@NullMarked
package org.selectiverenderer.radiosity.bake;

import org.jspecify.annotations.NullMarked;
