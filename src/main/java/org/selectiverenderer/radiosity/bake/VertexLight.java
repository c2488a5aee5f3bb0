package org.selectiverenderer.radiosity.bake;

/**
 * Irradiance at vertices.
 *
 * @param irradiance r, g, b per vertex, lx
 * @param complete whether every vertex was gathered; if not, the values are the patches' own
 * @param rays cast
 */
public record VertexLight(float[] irradiance, boolean complete, long rays) {}
