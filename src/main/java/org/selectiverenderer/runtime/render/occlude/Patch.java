package org.selectiverenderer.runtime.render.occlude;

/**
 * A flat part of a mesh that hides what is behind it: the triangles of one plane that face the same
 * way, as their outline. Local coordinates. The outline is what is left of the triangles' edges
 * when those that occur an even number of times are taken away: a point of the plane is inside when
 * a ray from it crosses the outline an odd number of times, and then some triangle covers it.
 *
 * @param points x, y, z per corner of the outline, as the mesh has them
 * @param edges two corners each, in no order; every corner has an even number of them
 * @param plane unit normal x, y, z towards the front, and its product with a point of the plane
 * @param thickness the distance from the plane that no triangle's corner exceeds
 * @param tilt the sine of the angle to the plane that no triangle exceeds
 * @param area of the triangles
 * @param sphere around the corners: centre x, y, z, radius
 */
record Patch(
    double[] points,
    int[] edges,
    double[] plane,
    double thickness,
    double tilt,
    double area,
    double[] sphere) {}
