package org.selectiverenderer.radiosity.scene;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Computes the diffuse reflectance of a mesh's triangles: the material's diffuse colour or the
 * vertex colours in its place, and textures averaged over each triangle.
 */
final class TriangleReflectance {
  /**
   * Largest reflectance: no surface reflects all light, and with 1 the light in a closed white box
   * would grow without limit.
   */
  private static final float MOST = 0.95f;

  /** Pixels per texture sample in a triangle; the number of samples is limited by the next two. */
  private static final double PIXELS = 4;

  private static final int LEAST_PLACES = 10;
  private static final int MOST_PLACES = 400;

  /** Steps of the low-discrepancy sequence R2 (Roberts 2018) from one sample to the next. */
  private static final double STEP_U = 0.7548776662466927;

  private static final double STEP_V = 0.5698402909980532;

  private TriangleReflectance() {}

  /** Returns r, g, b for all triangles together, or for each triangle. */
  static float[] of(SurfaceMaterial surface, Mesh mesh) {
    float opaque = 1 - surface.transparency();
    float[] colours = mesh.colors();
    Texture texture = mesh.hasTexCoords() ? surface.texture() : null;
    if (colours == null && texture == null) {
      return limited(Photometry.linear(surface.diffuse()), opaque);
    }
    int[] indices = mesh.indices();
    float[] all = new float[indices.length];
    for (int i = 0; i < indices.length; i += 3) {
      float[] rgb = surface.diffuse().clone();
      if (colours != null) {
        for (int c = 0; c < 3; c++) {
          rgb[c] =
              (colours[4 * indices[i] + c]
                      + colours[4 * indices[i + 1] + c]
                      + colours[4 * indices[i + 2] + c])
                  / 3;
        }
      }
      float[] linear = Photometry.linear(rgb);
      if (texture != null) {
        paint(linear, texture, surface.tints(), surface.textureTransform(), mesh, i);
      }
      System.arraycopy(limited(linear, opaque), 0, all, i, 3);
    }
    return all;
  }

  private static float[] limited(float[] rgb, float opaque) {
    for (int c = 0; c < 3; c++) {
      rgb[c] = Math.min(MOST, rgb[c]) * opaque;
    }
    return rgb;
  }

  /** Applies a texture, which multiplies or replaces the colour (X3D 4.0, 18.2.1). */
  private static void paint(
      float[] rgb,
      Texture texture,
      boolean tints,
      float @Nullable [] transform,
      Mesh mesh,
      int firstIndex) {
    double[] sum = new double[3];
    double[] st = new double[6];
    for (int corner = 0; corner < 3; corner++) {
      int at = 2 * mesh.indices()[firstIndex + corner];
      place(mesh.texCoords()[at], mesh.texCoords()[at + 1], transform, st, 2 * corner);
    }
    int places = places(st, texture.image());
    for (int i = 0; i < places; i++) {
      double u = (0.5 + i * STEP_U) % 1;
      double v = (0.5 + i * STEP_V) % 1;
      boolean outside = u + v > 1;
      add(texture, st, outside ? 1 - u : u, outside ? 1 - v : v, sum);
    }
    for (int c = 0; c < 3; c++) {
      double mean = sum[c] / places;
      rgb[c] = (float) (tints ? rgb[c] * mean : mean);
    }
  }

  private static void place(
      double s, double t, float @Nullable [] transform, double[] out, int at) {
    out[at] = transform == null ? s : transform[0] * s + transform[3] * t + transform[6];
    out[at + 1] = transform == null ? t : transform[1] * s + transform[4] * t + transform[7];
  }

  private static int places(double[] st, Texture.Image image) {
    double cross = (st[2] - st[0]) * (st[5] - st[1]) - (st[3] - st[1]) * (st[4] - st[0]);
    double pixels = Math.abs(cross) / 2 * image.width() * image.height();
    return (int) Math.max(LEAST_PLACES, Math.min(MOST_PLACES, pixels / PIXELS));
  }

  private static void add(Texture texture, double[] st, double u, double v, double[] sum) {
    double w = 1 - u - v;
    Texture.Image image = texture.image();
    int x = pixel(w * st[0] + u * st[2] + v * st[4], image.width(), texture.repeatS());
    int y = pixel(w * st[1] + u * st[3] + v * st[5], image.height(), texture.repeatT());
    int at = 4 * (y * image.width() + x);
    for (int c = 0; c < 3; c++) {
      sum[c] += Photometry.linear((image.rgba()[at + c] & 0xff) / 255.0);
    }
  }

  private static int pixel(double coordinate, int size, boolean repeats) {
    double place = repeats ? coordinate - Math.floor(coordinate) : coordinate;
    return (int) Math.max(0, Math.min(size - 1, place * size));
  }
}
