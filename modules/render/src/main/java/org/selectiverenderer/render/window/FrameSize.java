package org.selectiverenderer.render.window;

/**
 * The size of a frame.
 *
 * @param width in pixels
 * @param height in pixels
 * @param scale pixels per unit of the desktop: 2 on a display of double density
 */
public record FrameSize(int width, int height, float scale) {}
