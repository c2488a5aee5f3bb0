package org.selectiverenderer.browser.instance;

import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;

/**
 * Environment lighting as nine coefficients of spherical harmonics (R. Ramamoorthi, P. Hanrahan, An
 * Efficient Representation for Irradiance Environment Maps, SIGGRAPH 2001).
 */
final class SphericalHarmonics {
  /** The number of coefficients; each has red, green and blue. */
  static final int COUNT = 9;

  /**
   * Number of samples along a face's side; few suffice, since harmonics up to degree 2 are smooth.
   */
  private static final int PARTS = 32;

  /**
   * Factor of each coefficient for diffuse reflection: 1, 2/3 and 1/4 for the degrees 0, 1 and 2.
   */
  private static final double[] MATT = {1, 2 / 3.0, 2 / 3.0, 2 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25};

  /** For each face: its centre, and the vectors to the right and upper edge of its image. */
  private static final double[][] FACES = {
    {0, 0, -1, 1, 0, 0, 0, 1, 0},
    {0, 0, 1, -1, 0, 0, 0, 1, 0},
    {-1, 0, 0, 0, 0, -1, 0, 1, 0},
    {1, 0, 0, 0, 0, 1, 0, 1, 0},
    {0, 1, 0, 1, 0, 0, 0, 0, 1},
    {0, -1, 0, 1, 0, 0, 0, 0, -1}
  };

  private SphericalHarmonics() {}

  /**
   * Computes the coefficients of a cube map.
   *
   * @param matt whether the images show the incident light, which is to be convolved with the
   *     diffuse reflection; otherwise they show the reflected light already
   */
  static double[] of(CubeTexture cube, boolean matt) {
    double[] sums = new double[3 * COUNT];
    double weights = 0;
    double[] basis = new double[COUNT];
    double[] color = new double[3];
    for (int face = 0; face < CubeTexture.FACES; face++) {
      for (int row = 0; row < PARTS; row++) {
        for (int column = 0; column < PARTS; column++) {
          double u = 2 * (column + 0.5) / PARTS - 1;
          double v = 2 * (row + 0.5) / PARTS - 1;
          double weight = Math.pow(1 + u * u + v * v, -1.5);
          weights += weight;
          basis(direction(FACES[face], u, v), basis);
          mean(cube.faces().get(face), column, row, color);
          for (int i = 0; i < 3 * COUNT; i++) {
            sums[i] += weight * basis[i / 3] * color[i % 3];
          }
        }
      }
    }
    for (int i = 0; i < 3 * COUNT; i++) {
      sums[i] *= 4 * Math.PI / weights * (matt ? MATT[i / 3] : 1);
    }
    return sums;
  }

  /**
   * Converts coefficients of irradiance to those of the light that a white diffuse surface
   * reflects, which is the irradiance divided by pi.
   */
  static double[] ofFalling(float[] given) {
    double[] coefficients = new double[3 * COUNT];
    for (int i = 0; i < Math.min(given.length, coefficients.length); i++) {
      coefficients[i] = Float.isFinite(given[i]) ? given[i] / Math.PI : 0;
    }
    return coefficients;
  }

  private static Vector3d direction(double[] face, double u, double v) {
    return new Vector3d(
            face[0] + u * face[3] + v * face[6],
            face[1] + u * face[4] + v * face[7],
            face[2] + u * face[5] + v * face[8])
        .normalize();
  }

  private static void basis(Vector3d n, double[] out) {
    out[0] = 0.282095;
    out[1] = 0.488603 * n.y;
    out[2] = 0.488603 * n.z;
    out[3] = 0.488603 * n.x;
    out[4] = 1.092548 * n.x * n.y;
    out[5] = 1.092548 * n.y * n.z;
    out[6] = 0.315392 * (3 * n.z * n.z - 1);
    out[7] = 1.092548 * n.x * n.z;
    out[8] = 0.546274 * (n.x * n.x - n.y * n.y);
  }

  /** Computes the mean of a part of a face as linear light; images are sRGB-encoded. */
  private static void mean(CubeTexture.Face face, int column, int row, double[] out) {
    Texture.Image image = face.image();
    int left = column * image.width() / PARTS;
    int right = Math.max(left + 1, (column + 1) * image.width() / PARTS);
    int low = row * image.height() / PARTS;
    int high = Math.max(low + 1, (row + 1) * image.height() / PARTS);
    // A large image is subsampled, so that every part costs the same.
    int across = Math.max(1, (right - left) / 4);
    int up = Math.max(1, (high - low) / 4);
    double[] sum = new double[3];
    int count = 0;
    int first = face.layer() * image.width() * image.height();
    for (int y = low; y < high; y += up) {
      for (int x = left; x < right; x += across) {
        int at = 4 * (first + y * image.width() + x);
        for (int i = 0; i < 3; i++) {
          sum[i] += LINEAR.get(image.rgba()[at + i] & 0xff);
        }
        count++;
      }
    }
    for (int i = 0; i < 3; i++) {
      out[i] = sum[i] / count;
    }
  }

  /** The sRGB decoding of {@code material.glsl}, tabulated for bytes. */
  private static final List<Double> LINEAR =
      IntStream.range(0, 256).mapToObj(value -> Math.pow(value / 255.0, 2.2)).toList();
}
