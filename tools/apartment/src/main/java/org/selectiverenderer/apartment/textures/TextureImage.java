package org.selectiverenderer.apartment.textures;

import org.selectiverenderer.formats.image.CompactPngEncoder;
import org.selectiverenderer.formats.image.CompactPngEncoder.Samples;
import org.selectiverenderer.formats.image.Srgb;

/**
 * A texture image. The arrays must not be modified.
 *
 * @param samples meaning of a pixel's bytes
 * @param palette red, green and blue of each colour, for indexed-colour images
 * @param pixels rows from the top
 */
public record TextureImage(int width, int height, Samples samples, byte[] palette, byte[] pixels) {

  /** Returns the bytes of a PNG file. */
  public byte[] png() {
    return CompactPngEncoder.of(width, height, samples, palette, pixels);
  }

  /** Returns a channel of a pixel, 0 to 255, display-encoded: red, green, blue, or alpha. */
  public int sample(int x, int y, int channel) {
    int at = (y * width + x) * samples.count();
    return switch (samples) {
          case GREY -> pixels[at];
          case GREY_ALPHA -> pixels[at + channel / 3];
          case PALETTE -> palette[3 * (pixels[at] & 0xff) + channel];
          case RGB, RGBA -> pixels[at + channel];
        }
        & 0xff;
  }

  /** Returns the mean reflectance of the pixels: red, green, blue. */
  public double[] meanLight() {
    double[] light = new double[256];
    for (int i = 0; i < 256; i++) {
      light[i] = Srgb.light(i / 255.0);
    }
    double[] sum = new double[3];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        for (int c = 0; c < 3; c++) {
          sum[c] += light[sample(x, y, c)];
        }
      }
    }
    for (int c = 0; c < 3; c++) {
      sum[c] /= width * height;
    }
    return sum;
  }
}
