/**
 * Light sources: points, spots, the sun, rectangles such as windows, emissive surfaces.
 *
 * <p>In: their photometric values. Out: the light that falls on a point from a sampled point of the
 * lamp, and unshadowed irradiance. Uses {@code radiosity.trace}'s triangles.
 */
@NullMarked
package org.selectiverenderer.radiosity.light;

import org.jspecify.annotations.NullMarked;
