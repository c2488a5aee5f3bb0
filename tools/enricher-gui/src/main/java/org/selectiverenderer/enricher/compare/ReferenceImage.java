package org.selectiverenderer.enricher.compare;

import java.awt.image.BufferedImage;

/**
 * The reference image of a comparison: the scene in full detail.
 *
 * @param image of the same size and from the same viewpoint as the preview's picture
 * @param polygons of the whole scene
 */
public record ReferenceImage(CompareMode mode, BufferedImage image, long polygons) {}
