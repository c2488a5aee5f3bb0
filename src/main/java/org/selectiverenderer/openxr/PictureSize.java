package org.selectiverenderer.openxr;

/**
 * An eye's picture as the runtime recommends it.
 *
 * @param width in pixels
 * @param height in pixels
 * @param samples per pixel
 */
public record PictureSize(int width, int height, int samples) {}
