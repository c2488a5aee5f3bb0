package org.selectiverenderer.radiosity.bake;

/**
 * A lightmap page as an image in display colours.
 *
 * @param rgb three bytes per pixel, rows from the top
 */
public record LightmapImage(int width, int height, byte[] rgb) {}
