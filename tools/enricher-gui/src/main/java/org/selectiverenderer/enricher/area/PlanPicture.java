package org.selectiverenderer.enricher.area;

import java.awt.image.BufferedImage;
import org.selectiverenderer.geometry.Bounds;

/**
 * A scene from above without what is over a height; a value.
 *
 * @param extent of what is shown, in the scene; the picture covers its X from left to right and its
 *     Z from top to bottom
 * @param image what lies under the cut, transparent where nothing does
 * @param walls where the cut goes through surfaces: x1, z1, x2, z2 of each line
 * @param cut height
 */
public record PlanPicture(Bounds extent, BufferedImage image, float[] walls, double cut) {}
