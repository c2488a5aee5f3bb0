package org.selectiverenderer.render.occlusion;

/**
 * An occluder polygon: the outline of a mesh's coplanar triangles that face the same way, in local
 * coordinates. The outline consists of the triangles' edges that occur an odd number of times. A
 * point of the plane is inside when a ray from it crosses the outline an odd number of times, and
 * then at least one triangle covers it.
 *
 * @param points x, y, z per corner of the outline, as the mesh has them
 * @param edges two corners per edge, in no order; every corner has an even number of edges
 * @param plane unit normal x, y, z towards the front, and its dot product with a point of the plane
 * @param thickness the largest distance of a triangle's corner from the plane
 * @param tilt the largest sine of the angle between a triangle and the plane
 * @param area the area of the triangles
 * @param sphere the bounding sphere of the corners: centre x, y, z, radius
 */
record OccluderPolygon(
    double[] points,
    int[] edges,
    double[] plane,
    double thickness,
    double tilt,
    double area,
    double[] sphere) {}
