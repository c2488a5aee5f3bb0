package org.selectiverenderer.runtime.render;

/**
 * What a frame drew after culling.
 *
 * @param shapes with at least a part in view
 * @param triangles sent to the graphics card
 */
public record Drawn(int shapes, long triangles) {}
