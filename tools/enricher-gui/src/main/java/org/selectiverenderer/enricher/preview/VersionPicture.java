package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;

/**
 * A small picture of a version.
 *
 * @param image of the size asked for; nobody draws into it
 * @param polygons that the version has
 */
public record VersionPicture(BufferedImage image, long polygons) {}
