package org.selectiverenderer.models.gltf.write;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.formats.image.PngEncoder;

/**
 * An image that glTF can hold: PNG or JPEG.
 *
 * @param mimeType {@code image/png} or {@code image/jpeg}
 * @param grey whether it has no colours
 * @param translucent whether it may have pixels that are not opaque
 */
record GltfImage(byte[] bytes, String mimeType, boolean grey, boolean translucent) {

  /**
   * Returns a PNG or JPEG file as an image; empty for any other content, and for a JPEG file of
   * inks, which glTF readers need not know.
   */
  static Optional<GltfImage> of(byte[] bytes) {
    if (bytes.length > 33 && unsigned(bytes, 0) == 0x89504E47L) {
      int colours = bytes[25];
      boolean alpha = colours == 4 || colours == 6 || hasTransparency(bytes);
      return Optional.of(new GltfImage(bytes, "image/png", colours == 0 || colours == 4, alpha));
    }
    if (bytes.length > 4 && unsigned(bytes, 0) >>> 8 == 0xFFD8FFL) {
      int components = jpegComponents(bytes);
      return components > 3
          ? Optional.empty()
          : Optional.of(new GltfImage(bytes, "image/jpeg", components == 1, false));
    }
    return Optional.empty();
  }

  /**
   * Returns a PNG file of an SFImage; empty if it has no pixels.
   *
   * @param image width, height, components, and the pixels with rows from the bottom
   */
  static Optional<GltfImage> ofPixels(int[] image) {
    int width = image.length < 3 ? 0 : image[0];
    int height = image.length < 3 ? 0 : image[1];
    if (width <= 0 || height <= 0 || (long) width * height != image.length - 3L) {
      return Optional.empty();
    }
    int components = image[2];
    boolean alpha = components == 2 || components == 4;
    int size = alpha ? 4 : 3;
    byte[] pixels = new byte[size * width * height];
    int at = 0;
    for (int row = height - 1; row >= 0; row--) {
      for (int column = 0; column < width; column++) {
        int pixel = image[3 + row * width + column];
        int rgb = alpha ? pixel >>> 8 : pixel;
        boolean grey = components < 3;
        pixels[at] = (byte) (grey ? rgb : rgb >>> 16);
        pixels[at + 1] = (byte) (grey ? rgb : rgb >>> 8);
        pixels[at + 2] = (byte) rgb;
        if (alpha) {
          pixels[at + 3] = (byte) pixel;
        }
        at += size;
      }
    }
    byte[] png = PngEncoder.small(width, height, pixels);
    return Optional.of(new GltfImage(png, "image/png", components < 3, alpha));
  }

  /** Returns whether a PNG file has a chunk tRNS before its pixels. */
  private static boolean hasTransparency(byte[] png) {
    long at = 8;
    while (at + 8 <= png.length) {
      String chunk = new String(png, (int) at + 4, 4, StandardCharsets.ISO_8859_1);
      if (chunk.equals("tRNS") || chunk.equals("IDAT")) {
        return chunk.equals("tRNS");
      }
      at += 12 + unsigned(png, (int) at);
    }
    return false;
  }

  /** Returns the number of components in the frame header of a JPEG file; 3 if there is none. */
  private static int jpegComponents(byte[] jpeg) {
    int at = 2;
    while (at + 9 < jpeg.length && (jpeg[at] & 0xFF) == 0xFF) {
      int marker = jpeg[at + 1] & 0xFF;
      if (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) {
        return jpeg[at + 9];
      }
      at += 2 + ((jpeg[at + 2] & 0xFF) << 8 | jpeg[at + 3] & 0xFF);
    }
    return 3;
  }

  private static long unsigned(byte[] bytes, int at) {
    return (bytes[at] & 0xFFL) << 24
        | (bytes[at + 1] & 0xFFL) << 16
        | (bytes[at + 2] & 0xFFL) << 8
        | bytes[at + 3] & 0xFFL;
  }
}
