package org.selectiverenderer.radiosity.reference;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.radiosity.bake.ReinhardToneMapping;

/** Pictures of radiance, r, g, b per pixel in cd/m2, rows from the top. */
final class ComparisonImages {
  /** The relative difference that is shown in full red or blue. */
  static final double FULL = 0.2;

  private static final int GAP = 4;
  private static final byte BACKGROUND = (byte) 0x60;

  private final int width;
  private final int height;
  private final PrimaryHits hits;

  ComparisonImages(PrimaryHits hits) {
    this.hits = hits;
    width = hits.width();
    height = hits.height();
  }

  /** As a display shows it: r, g, b in bytes. */
  byte[] shown(double[] light, ReinhardToneMapping curve) {
    byte[] rgb = new byte[3 * width * height];
    float[] colour = new float[3];
    for (int i = 0; i < width * height; i++) {
      double covered = hits.covered(i);
      curve.colour(light[3 * i], light[3 * i + 1], light[3 * i + 2], colour, 0);
      for (int c = 0; c < 3; c++) {
        double value = 255 * colour[c] + (1 - covered) * (BACKGROUND & 0xff);
        rgb[3 * i + c] = (byte) Math.min(255, Math.round(value));
      }
    }
    return rgb;
  }

  /** White where both agree, red where ours is brighter by up to {@link #FULL}, blue darker. */
  byte[] difference(double[] ours, double[] reference) {
    byte[] rgb = new byte[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      double wanted = ImageErrorMetrics.luminance(reference, i);
      double off = wanted > 0 ? ImageErrorMetrics.luminance(ours, i) / wanted - 1 : 0;
      double share = Math.max(-1, Math.min(1, off / FULL));
      boolean nothing = hits.covered(i) == 0;
      rgb[3 * i] = nothing ? BACKGROUND : (byte) Math.round(255 * (1 + Math.min(0, share)));
      rgb[3 * i + 1] = nothing ? BACKGROUND : (byte) Math.round(255 * (1 - Math.abs(share)));
      rgb[3 * i + 2] = nothing ? BACKGROUND : (byte) Math.round(255 * (1 - Math.max(0, share)));
    }
    return rgb;
  }

  byte[] png(byte[] rgb) {
    return PngEncoder.of(width, height, rgb);
  }

  /** Pictures from left to right, as a PNG file. */
  byte[] beside(byte[]... pictures) {
    int all = pictures.length * (width + GAP) - GAP;
    byte[] rgb = new byte[3 * all * height];
    java.util.Arrays.fill(rgb, (byte) 0xff);
    for (int k = 0; k < pictures.length; k++) {
      for (int y = 0; y < height; y++) {
        System.arraycopy(
            pictures[k], 3 * y * width, rgb, 3 * (y * all + k * (width + GAP)), 3 * width);
      }
    }
    return PngEncoder.of(all, height, rgb);
  }

  /** A portable float map (Debevec): its rows go from the bottom up. */
  byte[] floats(double[] light) {
    byte[] head = "PF\n%d %d\n-1.0\n".formatted(width, height).getBytes(StandardCharsets.US_ASCII);
    ByteBuffer out =
        ByteBuffer.allocate(head.length + 12 * width * height).order(ByteOrder.LITTLE_ENDIAN);
    out.put(head);
    for (int y = height - 1; y >= 0; y--) {
      for (int i = 3 * y * width; i < 3 * (y + 1) * width; i++) {
        out.putFloat((float) light[i]);
      }
    }
    return out.array();
  }
}
