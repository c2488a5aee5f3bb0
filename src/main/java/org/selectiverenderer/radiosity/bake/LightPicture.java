package org.selectiverenderer.radiosity.bake;

/**
 * A page as it is shown.
 *
 * @param rgb three bytes per pixel, rows from the top
 */
public record LightPicture(int width, int height, byte[] rgb) {}
