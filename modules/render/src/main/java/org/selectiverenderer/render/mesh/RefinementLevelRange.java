package org.selectiverenderer.render.mesh;

/**
 * A range of an index buffer that draws a coarser refinement level: the same surface with fewer
 * triangles.
 *
 * @param clusters the clusters of the range
 * @param undivided the longest of its edges that finer levels split, in the coordinates of the
 *     buffers
 */
public record RefinementLevelRange(TriangleClusters clusters, double undivided) {}
