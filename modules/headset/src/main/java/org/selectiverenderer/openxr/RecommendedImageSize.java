package org.selectiverenderer.openxr;

/**
 * The size of an eye's picture that the runtime recommends.
 *
 * @param width in pixels
 * @param height in pixels
 * @param samples recommended samples per pixel
 */
public record RecommendedImageSize(int width, int height, int samples) {}
