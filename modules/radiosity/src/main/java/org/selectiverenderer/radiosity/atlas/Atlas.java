package org.selectiverenderer.radiosity.atlas;

import java.util.List;

/**
 * The lightmap atlas of a scene: its pages, and the texture coordinates of each body on its page.
 * All bodies of a page are written to one file.
 *
 * @param pages the pages, in the order of the files
 * @param layouts the layout of each body, in the order of the scene's bodies
 */
public record Atlas(List<AtlasPage> pages, List<Layout> layouts) {

  /**
   * The page of a body and its texture coordinates there.
   *
   * @param page number of the page, {@link AtlasPage#NONE} for none
   * @param st texture coordinates, 0 .. 1 of the page: s and t of the three corners of each
   *     triangle of the body in the order of {@link
   *     org.selectiverenderer.radiosity.scene.Body#vertex}, six numbers per triangle
   */
  public record Layout(int page, float[] st) {

    /**
     * Returns the texture coordinate s of a point of a triangle, 0 .. 1 from left to right.
     *
     * @param triangle number of the triangle in the body
     * @param u weight of its second corner
     * @param v weight of its third corner
     */
    public double s(int triangle, double u, double v) {
      return between(6 * triangle, u, v);
    }

    /** Returns the texture coordinate t of a point of a triangle, 0 .. 1 from bottom to top. */
    public double t(int triangle, double u, double v) {
      return between(6 * triangle + 1, u, v);
    }

    private double between(int at, double u, double v) {
      return (1 - u - v) * st[at] + u * st[at + 2] + v * st[at + 4];
    }
  }

  /** Returns the number of texels of all pages, gutters included. */
  public long texels() {
    return pages.stream().mapToLong(AtlasPage::texels).sum();
  }
}
