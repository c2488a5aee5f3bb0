package org.selectiverenderer.geometry.font;

/**
 * A character's shape, in ems, from its origin on the base line; y is up. Nobody writes into the
 * arrays.
 *
 * @param advance the way to the next glyph's origin
 * @param points x, y per point
 * @param indices three points per triangle, counter-clockwise
 */
public record Glyph(float advance, float[] points, int[] indices) {}
