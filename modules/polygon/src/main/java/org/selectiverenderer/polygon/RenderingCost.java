package org.selectiverenderer.polygon;

/**
 * What a part of a scene costs to draw beside its polygons.
 *
 * @param drawCalls shapes that are drawn, each place of a shape that is used several times counted
 * @param textureBytes bytes of the pictures of these shapes in the memory of a graphics card:
 *     decoded to four bytes a pixel, with mip maps, each picture once; pictures of the web and
 *     films are not counted
 */
public record RenderingCost(long drawCalls, long textureBytes) {
  /** Nothing is drawn. */
  public static final RenderingCost NONE = new RenderingCost(0, 0);
}
