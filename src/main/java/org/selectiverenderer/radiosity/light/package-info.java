/**
 * What shines: points, spots, the sun, rectangles such as windows, glowing surfaces.
 *
 * <p>In: their photometric values. Out: light that falls on a point from a sampled place of the
 * lamp. Uses {@code radiosity.trace}'s triangles.
 */
@NullMarked
package org.selectiverenderer.radiosity.light;

import org.jspecify.annotations.NullMarked;
