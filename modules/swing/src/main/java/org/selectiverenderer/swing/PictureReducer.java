package org.selectiverenderer.swing;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import javax.imageio.IIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.ImageOutputStream;

/**
 * Reduces picture files in size. Each pixel is the mean of those that it covers, weighted by their
 * opacity. Needs no display.
 */
public final class PictureReducer {
  /** 8192 x 8192, as many as a texture may have. */
  private static final long MAX_PIXELS = 1L << 26;

  private static final float JPEG_QUALITY = 0.9f;

  private PictureReducer() {}

  /**
   * Returns the file of a smaller picture: a JPEG of a JPEG, else a PNG.
   *
   * @param percent of each side, above 0 and below 100; no side gets shorter than a pixel
   * @throws IOException if the picture cannot be read, with a one-line message that names it
   */
  public static byte[] reduced(Path picture, double percent) throws IOException {
    try (ImageInputStream in = ImageIO.createImageInputStream(picture.toFile())) {
      Iterator<ImageReader> readers = in == null ? null : ImageIO.getImageReaders(in);
      if (readers == null || !readers.hasNext()) {
        throw new IOException(picture + " is no picture that can be reduced (PNG, JPEG, GIF, BMP)");
      }
      ImageReader reader = readers.next();
      try {
        reader.setInput(in, true, true);
        if ((long) reader.getWidth(0) * reader.getHeight(0) > MAX_PIXELS) {
          throw new IOException(picture + " has more than 8192 x 8192 pixels");
        }
        boolean jpeg = reader.getFormatName().toLowerCase(Locale.ROOT).equals("jpeg");
        return written(reduced(reader.read(0), percent), jpeg);
      } catch (RuntimeException | IIOException e) {
        // ImageIO's readers throw various runtime exceptions for damaged files.
        throw new IOException(
            picture + " is a damaged picture, or one of a kind that is unknown", e);
      } finally {
        reader.dispose();
      }
    }
  }

  private static BufferedImage reduced(BufferedImage picture, double percent) {
    int width = side(picture.getWidth(), percent);
    int height = side(picture.getHeight(), percent);
    boolean opaque = !picture.getColorModel().hasAlpha();
    BufferedImage small =
        new BufferedImage(
            width, height, opaque ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
    for (int y = 0; y < height; y++) {
      int top = (int) ((long) y * picture.getHeight() / height);
      int bottom = Math.max(top + 1, (int) ((long) (y + 1) * picture.getHeight() / height));
      for (int x = 0; x < width; x++) {
        int left = (int) ((long) x * picture.getWidth() / width);
        int right = Math.max(left + 1, (int) ((long) (x + 1) * picture.getWidth() / width));
        small.setRGB(x, y, mean(picture, left, top, right, bottom));
      }
    }
    return small;
  }

  private static int side(int pixels, double percent) {
    return (int) Math.max(1, Math.round(pixels * percent / 100));
  }

  private static int mean(BufferedImage picture, int left, int top, int right, int bottom) {
    long opacity = 0;
    long[] sums = new long[3];
    for (int y = top; y < bottom; y++) {
      for (int x = left; x < right; x++) {
        int pixel = colour(picture, x, y);
        int alpha = pixel >>> 24;
        opacity += alpha;
        for (int c = 0; c < 3; c++) {
          sums[c] += (long) alpha * (pixel >> (16 - 8 * c) & 255);
        }
      }
    }
    long count = (long) (right - left) * (bottom - top);
    int mean = (int) ((opacity + count / 2) / count) << 24;
    for (int c = 0; c < 3 && opacity > 0; c++) {
      mean |= (int) ((sums[c] + opacity / 2) / opacity) << (16 - 8 * c);
    }
    return mean;
  }

  /** Returns a pixel as ARGB; Java would take the samples of a grey picture for linear light. */
  private static int colour(BufferedImage picture, int x, int y) {
    ColorModel model = picture.getColorModel();
    if (model.getColorSpace().getType() != ColorSpace.TYPE_GRAY || model.getPixelSize() > 16) {
      return picture.getRGB(x, y);
    }
    WritableRaster samples = picture.getRaster();
    int grey = samples.getSample(x, y, 0) >> Math.max(0, model.getComponentSize(0) - 8);
    int opacity = samples.getNumBands() > 1 ? samples.getSample(x, y, 1) : 255;
    return opacity << 24 | grey << 16 | grey << 8 | grey;
  }

  private static byte[] written(BufferedImage picture, boolean jpeg) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    if (!jpeg) {
      ImageIO.write(picture, "png", bytes);
      return bytes.toByteArray();
    }
    ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    try (ImageOutputStream out = ImageIO.createImageOutputStream(bytes)) {
      ImageWriteParam parameters = writer.getDefaultWriteParam();
      parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      parameters.setCompressionQuality(JPEG_QUALITY);
      writer.setOutput(out);
      writer.write(null, new IIOImage(picture, null, null), parameters);
    } finally {
      writer.dispose();
    }
    return bytes.toByteArray();
  }
}
