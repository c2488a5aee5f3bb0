package org.selectiverenderer.enricher.compare;

import java.awt.image.BufferedImage;

/**
 * The scene with all polygons.
 *
 * @param image of the same size and seen from the same place as the other
 * @param polygons of the whole scene
 */
public record Compared(CompareMode mode, BufferedImage image, long polygons) {}
