package org.selectiverenderer.geometry.font;

/**
 * The triangles of a glyph, in ems, relative to its origin on the baseline with y up. The arrays
 * must not be modified.
 *
 * @param advance the advance width, from this glyph's origin to the next one's
 * @param points x, y per point
 * @param indices three points per triangle, counter-clockwise
 */
public record Glyph(float advance, float[] points, int[] indices) {}
