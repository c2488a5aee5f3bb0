package org.selectiverenderer.browser.loading;

import java.awt.image.Raster;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageReader;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Converts CMYK JPEG images, which prepress programs write, to RGB; ImageIO only reads their raw
 * samples. The conversion assumes ideal inks and ignores colour profiles.
 */
final class CmykJpegDecoder {
  /**
   * The colour transform of an Adobe segment that stands for YCCK: inks as luma and two chroma
   * differences.
   */
  private static final int YCCK = 2;

  private static final int NO_ADOBE = -1;

  private CmykJpegDecoder() {}

  /** Returns whether an image that a reader is about to read is CMYK. */
  static boolean is(ImageReader reader, UrlContent file) throws IOException {
    return reader.getFormatName().equalsIgnoreCase("jpeg") && components(file) == 4;
  }

  /**
   * @param raster the samples, with four bands
   */
  static Texture.Image read(Raster raster, UrlContent file) throws IOException {
    int transform = adobe(file);
    int width = raster.getWidth();
    int height = raster.getHeight();
    byte[] rgba = new byte[width * height * 4];
    int[] row = new int[4 * width];
    for (int y = 0; y < height; y++) {
      raster.getPixels(0, y, width, 1, row);
      int at = (height - 1 - y) * width * 4;
      for (int x = 0; x < width; x++, at += 4) {
        double a = row[4 * x];
        double b = row[4 * x + 1];
        double c = row[4 * x + 2];
        double k = row[4 * x + 3];
        if (transform == YCCK) {
          double light = a;
          double blue = b - 128;
          double red = c - 128;
          a = light + 1.402 * red;
          b = light - 0.344136 * blue - 0.714136 * red;
          c = light + 1.772 * blue;
        }
        // Adobe's programs write inverted ink values, others the ink values themselves.
        boolean missing = transform != NO_ADOBE;
        rgba[at] = shade(a, k, missing);
        rgba[at + 1] = shade(b, k, missing);
        rgba[at + 2] = shade(c, k, missing);
        rgba[at + 3] = (byte) 255;
      }
    }
    return new Texture.Image(width, height, 3, rgba);
  }

  private static byte shade(double ink, double black, boolean missing) {
    double bright = Math.max(0, Math.min(255, ink));
    return (byte) Math.round((missing ? bright * black : (255 - bright) * (255 - black)) / 255);
  }

  private static int components(UrlContent file) throws IOException {
    return segments(file, true);
  }

  /** Returns the colour transform that an Adobe segment names, or {@link #NO_ADOBE}. */
  private static int adobe(UrlContent file) throws IOException {
    return segments(file, false);
  }

  /** Searches the segments before the image data (ITU-T T.81, B.1.1). */
  private static int segments(UrlContent file, boolean frame) throws IOException {
    try (InputStream stream = file.open();
        DataInputStream in = new DataInputStream(new BufferedInputStream(stream))) {
      in.readUnsignedShort();
      while (true) {
        int marker = in.readUnsignedShort() & 0xff;
        if (marker == 0xda) {
          return NO_ADOBE;
        }
        byte[] body = new byte[Math.max(0, in.readUnsignedShort() - 2)];
        in.readFully(body);
        boolean isFrame = marker >= 0xc0 && marker <= 0xcf && marker % 4 != 0 || marker == 0xc0;
        if (frame && isFrame && body.length > 5) {
          return body[5];
        }
        if (!frame
            && marker == 0xee
            && body.length >= 12
            && new String(body, 0, 5, StandardCharsets.US_ASCII).equals("Adobe")) {
          return body[11];
        }
      }
    } catch (EOFException e) {
      return NO_ADOBE; // The file is damaged; the image reader will report it.
    }
  }
}
