package org.selectiverenderer.runtime.render.mesh;

/**
 * A stretch of an index buffer that draws the same surface as another one with fewer triangles.
 *
 * @param clusters of the stretch
 * @param undivided the longest edge in it that the other divides, in the coordinates of the buffers
 */
public record CoarserPart(Clusters clusters, double undivided) {}
