package org.selectiverenderer.validation;

/**
 * What is known of a geometry node without drawing it.
 *
 * @param polygons triangles
 * @param bounds least x, y, z, then greatest, in the node's coordinates; empty when nothing is
 *     drawn
 */
public record GeometryMeasure(int polygons, float[] bounds) {}
