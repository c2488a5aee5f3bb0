package org.selectiverenderer.apartment.textures;

import java.util.stream.IntStream;
import org.selectiverenderer.formats.image.CompactPngEncoder.Samples;

/**
 * One face of the landscape's skybox, which X3D's Background shows infinitely far away (X3D 4.0,
 * 24.4.1), so that it moves behind a window's frame as one walks. Where there is sky, or the ground
 * straight below, the face is transparent and the Background's own colours show.
 *
 * @param x with {@code z} the direction of the face's middle; y is 0
 */
record SkyboxFace(double x, double z) {
  static final SkyboxFace NORTH = new SkyboxFace(0, -1);
  static final SkyboxFace EAST = new SkyboxFace(1, 0);
  static final SkyboxFace SOUTH = new SkyboxFace(0, 1);
  static final SkyboxFace WEST = new SkyboxFace(-1, 0);

  /**
   * Pixels of a side: so few that the landscape is slightly out of focus, as it is for an eye in a
   * room.
   */
  private static final int PIXELS = 512;

  /** Samples of a pixel, across and up, where there are outlines, that is near the horizon. */
  private static final int SAMPLES = 2;

  /** Largest distance of outlines from the horizon, as a share of half the face. */
  private static final double OUTLINES = 0.3;

  /**
   * Heights at which the image begins to fade out at the top and at the bottom, as shares of half
   * the face.
   */
  private static final double TOP = 0.62;

  private static final double BOTTOM = -0.72;

  TextureImage picture() {
    Landscape land = new Landscape();
    byte[] pixels = new byte[4 * PIXELS * PIXELS];
    IntStream.range(0, PIXELS).parallel().forEach(row -> row(land, row, pixels));
    return new TextureImage(PIXELS, PIXELS, Samples.RGBA, new byte[0], pixels);
  }

  private void row(Landscape land, int row, byte[] pixels) {
    int samples = Math.abs(place(row, 0, 1)) < OUTLINES ? SAMPLES : 1;
    for (int column = 0; column < PIXELS; column++) {
      double[] sum = new double[4];
      for (int i = 0; i < samples * samples; i++) {
        double right = place(column, i % samples, samples);
        double up = -place(row, i / samples, samples);
        // A viewer who looks along (x, z) has (-z, x) to the right.
        double[] seen = land.colour(x - z * right, up, z + x * right);
        double opaque = seen[3] * PerlinNoise.step(1, TOP, up) * PerlinNoise.step(-1, BOTTOM, up);
        for (int c = 0; c < 3; c++) {
          sum[c] += opaque * Math.max(0, Math.min(1, seen[c]));
        }
        sum[3] += opaque;
      }
      int at = 4 * (row * PIXELS + column);
      for (int c = 0; c < 3; c++) {
        pixels[at + c] = (byte) Math.round(sum[3] > 0 ? 255 * sum[c] / sum[3] : 224);
      }
      pixels[at + 3] = (byte) Math.round(255 * sum[3] / (samples * samples));
    }
  }

  /** Returns the coordinate of a sample, -1 to 1 from the left or upper edge. */
  private static double place(int pixel, int sample, int samples) {
    return (2 * pixel + (2 * sample + 1.0) / samples) / PIXELS - 1;
  }
}
