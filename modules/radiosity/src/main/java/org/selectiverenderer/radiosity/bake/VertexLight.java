package org.selectiverenderer.radiosity.bake;

/**
 * Irradiance at vertices.
 *
 * @param irradiance r, g, b of each vertex, lx
 * @param complete whether every vertex was gathered; if not, the values are those of the patches
 * @param rays number of rays cast
 */
public record VertexLight(float[] irradiance, boolean complete, long rays) {}
