package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;

/**
 * A small rendered picture of a version.
 *
 * @param image image of the requested size; must not be changed
 * @param polygons number of polygons of the version
 */
public record VersionImage(BufferedImage image, long polygons) {}
