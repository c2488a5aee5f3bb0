package org.selectiverenderer.render;

/**
 * Counts of what a frame drew after culling.
 *
 * @param shapes of which at least a part is in view
 * @param triangles that were sent to the graphics card
 */
public record FrameStatistics(int shapes, long triangles) {}
