package org.selectiverenderer.enricher.area;

import java.awt.image.BufferedImage;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * An image of a scene from above, without what lies above a cutting height; a value.
 *
 * @param extent bounds of what is shown, in world coordinates; the image covers X from left to
 *     right and Z from top to bottom
 * @param image the surfaces below the cut, transparent where there are none
 * @param walls the line segments in which the cut meets surfaces: x1, z1, x2, z2 of each
 * @param cut height of the cut in metres, world Y
 */
public record FloorPlanImage(BoundingBox extent, BufferedImage image, float[] walls, double cut) {}
