package org.selectiverenderer.radiosity.scene;

import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.instance.Texture;

/**
 * The share of light that surfaces throw back: the diffuse colour, colours at vertices in its
 * place, and textures averaged over each triangle.
 */
final class Reflectance {
  /** Nothing throws back all light; without this a closed white box would grow bright for ever. */
  private static final float MOST = 0.95f;

  /** Places in a triangle at which a texture is looked at, as weights of two corners. */
  private static final double[][] PLACES = {
    {1 / 3.0, 1 / 3.0},
    {0.1, 0.1},
    {0.8, 0.1},
    {0.1, 0.8},
    {0.45, 0.1},
    {0.1, 0.45},
    {0.45, 0.45},
    {0.6, 0.2},
    {0.2, 0.6},
    {0.2, 0.2}
  };

  private Reflectance() {}

  /** Three numbers for all triangles, or three for each. */
  static float[] of(Surface surface, Mesh mesh) {
    float opaque = 1 - surface.transparency();
    float[] colours = mesh.colors();
    Texture texture = mesh.texCoords() == null ? null : surface.texture();
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

  /** An image tints or replaces the colour (X3D 4.0, 18.2.1). */
  private static void paint(
      float[] rgb, Texture texture, boolean tints, float[] transform, Mesh mesh, int firstIndex) {
    double[] sum = new double[3];
    for (double[] place : PLACES) {
      double s = 0;
      double t = 0;
      double[] weights = {1 - place[0] - place[1], place[0], place[1]};
      for (int corner = 0; corner < 3; corner++) {
        int at = 2 * mesh.indices()[firstIndex + corner];
        s += weights[corner] * mesh.texCoords()[at];
        t += weights[corner] * mesh.texCoords()[at + 1];
      }
      if (transform != null) {
        double turned = transform[0] * s + transform[3] * t + transform[6];
        t = transform[1] * s + transform[4] * t + transform[7];
        s = turned;
      }
      Texture.Image image = texture.image();
      int x = pixel(s, image.width(), texture.repeatS());
      int y = pixel(t, image.height(), texture.repeatT());
      int at = 4 * (y * image.width() + x);
      for (int c = 0; c < 3; c++) {
        sum[c] += Photometry.linear((image.rgba()[at + c] & 0xff) / 255.0);
      }
    }
    for (int c = 0; c < 3; c++) {
      double mean = sum[c] / PLACES.length;
      rgb[c] = (float) (tints ? rgb[c] * mean : mean);
    }
  }

  private static int pixel(double coordinate, int size, boolean repeats) {
    double place = repeats ? coordinate - Math.floor(coordinate) : coordinate;
    return (int) Math.max(0, Math.min(size - 1, place * size));
  }
}
