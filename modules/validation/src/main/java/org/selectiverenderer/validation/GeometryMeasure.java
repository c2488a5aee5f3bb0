package org.selectiverenderer.validation;

/**
 * The polygon count and bounds of a geometry node.
 *
 * @param polygons number of triangles
 * @param bounds least x, y, z, then greatest x, y, z, in the node's coordinates; empty when nothing
 *     is drawn
 */
public record GeometryMeasure(int polygons, float[] bounds) {}
