package org.selectiverenderer.radiosity.atlas;

import java.util.List;

/**
 * The pictures that hold a scene's light, and where each body lies on them. All bodies of a page
 * are written to one file.
 *
 * @param pages in the order of the files
 * @param layouts by the bodies of the scene
 */
public record Atlas(List<TexelMap> pages, List<Layout> layouts) {

  /**
   * A body on its page.
   *
   * @param page its number
   * @param st texture coordinates, 0 .. 1 of the page: s and t of the three corners of each
   *     triangle of the body in the order of {@link
   *     org.selectiverenderer.radiosity.scene.Body#vertex}, six numbers per triangle
   */
  public record Layout(int page, float[] st) {

    /**
     * How far to the right on its page a place of a triangle lies, 0 .. 1.
     *
     * @param triangle of the body
     * @param u weight of its second corner
     * @param v weight of its third corner
     */
    public double s(int triangle, double u, double v) {
      return between(6 * triangle, u, v);
    }

    /** How far up it lies, 0 .. 1. */
    public double t(int triangle, double u, double v) {
      return between(6 * triangle + 1, u, v);
    }

    private double between(int at, double u, double v) {
      return (1 - u - v) * st[at] + u * st[at + 2] + v * st[at + 4];
    }
  }

  /** All texels of all pages, gutters among them. */
  public long texels() {
    return pages.stream().mapToLong(TexelMap::texels).sum();
  }
}
