package org.selectiverenderer.radiosity.bake;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.Photometry;

/**
 * Computes the diffuse reflectance of a body at each surface point, as its lightmap takes it. The
 * body's own texture is either merged into the lightmap or stays a texture that the lightmap is
 * multiplied by; in the second case the texture's mean is used here.
 */
final class TexelReflectance {
  /** Largest reflectance of a surface: see {@code scene.Reflectance}. */
  private static final double MOST = 0.95;

  private final Body body;
  private final @Nullable DiffuseTexture own;
  private final double @Nullable [] mean;
  private final float[] diffuse;
  private final double[] image = new double[4];
  private final double[] st = new double[2];

  /**
   * @param own the body's own texture, or null
   * @param mean mean linear colour of that texture if it stays a texture of its own; else null
   */
  TexelReflectance(Body body, @Nullable DiffuseTexture own, double @Nullable [] mean) {
    this.body = body;
    this.own = own;
    this.mean = mean;
    diffuse = Photometry.linear(body.shape().surface().diffuse());
  }

  /**
   * Computes the reflectance at a surface point.
   *
   * @param triangle number of the triangle in the body
   * @param u barycentric weight of its second corner; {@code v} that of the third
   * @param out receives r, g, b
   */
  void reflectance(int triangle, double u, double v, double[] out) {
    SurfaceMaterial surface = body.shape().surface();
    float[] colours = body.mesh().colors();
    if (!surface.lit() || own == null && colours == null) {
      int at = body.reflectanceAt(triangle);
      for (int c = 0; c < 3; c++) {
        out[c] = body.reflectance()[at + c];
      }
      return;
    }
    for (int c = 0; c < 3; c++) {
      out[c] = colours == null ? diffuse[c] : colour(colours, triangle, u, v, c);
    }
    if (own != null) {
      paint(own, triangle, u, v, out);
    }
    double opaque = 1.0 - surface.transparency();
    for (int c = 0; c < 3; c++) {
      out[c] = Math.min(MOST, out[c]) * opaque;
    }
  }

  private void paint(DiffuseTexture texture, int triangle, double u, double v, double[] out) {
    double[] light = mean;
    if (light == null) {
      texture.place(triangle, u, v, st);
      texture.sample(st, image);
      light = image;
    }
    for (int c = 0; c < 3; c++) {
      out[c] = texture.tints() ? out[c] * light[c] : light[c];
    }
  }

  /**
   * Interpolates display-encoded vertex colours between the corners and decodes the result to
   * linear light.
   */
  private double colour(float[] colours, int triangle, double u, double v, int c) {
    return Photometry.linear(
        (1 - u - v) * colours[4 * body.vertex(triangle, 0) + c]
            + u * colours[4 * body.vertex(triangle, 1) + c]
            + v * colours[4 * body.vertex(triangle, 2) + c]);
  }
}
