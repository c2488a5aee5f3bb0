package org.selectiverenderer.browser.loading;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.Raster;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Iterator;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Decodes image files (PNG, JPEG, GIF, BMP, TGA, DDS, KTX2, Radiance) and the pixels in fields of
 * texture nodes. Needs no display.
 */
final class ImageDecoder {
  /**
   * Largest number of pixels of an image, 8192 x 8192; larger ones are refused before memory is
   * allocated.
   */
  static final long MAX_PIXELS = 1L << 26;

  /**
   * Bytes per pixel while an image is being read: up to eight as decoded by ImageIO (four samples
   * of 16 bits), and four as kept.
   */
  private static final int BYTES = 12;

  /** Largest size in bytes of a file that is read into memory as a whole. */
  private static final long SMALL = 1L << 25;

  private ImageDecoder() {}

  /**
   * @param budget the bytes left for images; reduced by this image
   * @throws IOException if the image cannot be read; {@link Failure#clause} gives the reason
   */
  static Texture.Image read(UrlContent file, AtomicLong budget) throws IOException {
    if (TgaDecoder.is(file.name())) {
      return TgaDecoder.read(whole(file), budget);
    }
    // Most files are small and read at once; of a large one the beginning suffices to recognise the
    // format.
    boolean small = file.size() <= SMALL;
    byte[] bytes = small ? whole(file) : beginning(file);
    if (DdsDecoder.is(bytes)) {
      return DdsDecoder.read(small ? bytes : whole(file), budget);
    }
    if (Ktx2Decoder.is(bytes)) {
      return Ktx2Decoder.read(small ? bytes : whole(file), budget);
    }
    if (HdrDecoder.is(bytes)) {
      return HdrDecoder.read(small ? bytes : whole(file), budget);
    }
    Optional<Texture.Image> png = small ? png(bytes, budget) : Optional.empty();
    return png.isPresent() ? png.get() : byLibrary(small ? known(file, bytes) : file, budget);
  }

  /** Wraps the bytes of a file that has been read, since several decoders open it in turn. */
  private static UrlContent known(UrlContent file, byte[] bytes) {
    return new UrlContent.OfBytes(file.key(), file.name(), file.base(), bytes);
  }

  private static Optional<Texture.Image> png(byte[] whole, AtomicLong budget) throws IOException {
    Optional<PngDecoder> png = PngDecoder.of(whole);
    if (png.isEmpty()) {
      return Optional.empty();
    }
    spend(png.get().pixels(), budget);
    Optional<Texture.Image> image = png.get().decode();
    if (image.isEmpty()) {
      budget.addAndGet(BYTES * png.get().pixels());
    }
    return image;
  }

  private static Texture.Image byLibrary(UrlContent file, AtomicLong budget) throws IOException {
    try (InputStream in = file.open();
        ImageInputStream stream = new MemoryCacheImageInputStream(in)) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
      if (!readers.hasNext()) {
        throw new IOException(
            "is not an image of a known format (PNG, JPEG, GIF, BMP, TGA, DDS, KTX2 or HDR)");
      }
      ImageReader reader = readers.next();
      try {
        reader.setInput(stream, true, true);
        spend((long) reader.getWidth(0) * reader.getHeight(0), budget);
        return CmykJpegDecoder.is(reader, file)
            ? CmykJpegDecoder.read(reader.readRaster(0, null), file)
            : convert(reader.read(0));
      } catch (IIOException | EOFException | RuntimeException e) {
        // ImageIO's readers throw various runtime exceptions for damaged files.
        throw new IOException("is a damaged image", e);
      } finally {
        reader.dispose();
      }
    }
  }

  /** Returns whether a file is an image of a supported format, judged by its first bytes. */
  static boolean knows(UrlContent file) throws IOException {
    byte[] beginning = beginning(file);
    if (TgaDecoder.is(file.name())
        || DdsDecoder.is(beginning)
        || Ktx2Decoder.is(beginning)
        || HdrDecoder.is(beginning)) {
      return true;
    }
    try (InputStream in = file.open();
        ImageInputStream stream = new MemoryCacheImageInputStream(in)) {
      return ImageIO.getImageReaders(stream).hasNext();
    }
  }

  private static byte[] beginning(UrlContent file) throws IOException {
    try (InputStream in = file.open()) {
      return in.readNBytes(DdsDecoder.HEADER);
    }
  }

  private static byte[] whole(UrlContent file) throws IOException {
    return file.bytes((int) (4 * MAX_PIXELS));
  }

  static void spend(long pixels, AtomicLong budget) throws IOException {
    spend(pixels, BYTES, budget);
  }

  /**
   * Takes the memory for an image from a budget.
   *
   * @param bytes the bytes per pixel
   * @throws IOException with a clause as message if the budget does not suffice
   */
  static void spend(long pixels, int bytes, AtomicLong budget) throws IOException {
    if (pixels > MAX_PIXELS) {
      throw new IOException(
          "has %s pixels, more than the limit of %s".formatted(pixels, MAX_PIXELS));
    }
    if (budget.addAndGet(-bytes * pixels) < 0) {
      budget.addAndGet(bytes * pixels);
      throw new IOException(
          "has %s pixels, for which there is not enough memory".formatted(pixels));
    }
  }

  private static Texture.Image convert(BufferedImage image) {
    boolean samples = image.getColorModel() instanceof ComponentColorModel;
    if (samples && image.getColorModel().getNumColorComponents() == 1) {
      return grey(image.getRaster(), image.getColorModel().getComponentSize(0));
    }
    int width = image.getWidth();
    int height = image.getHeight();
    byte[] rgba = new byte[width * height * 4];
    int[] row = new int[width];
    for (int y = 0; y < height; y++) {
      image.getRGB(0, y, width, 1, row, 0, width);
      int at = (height - 1 - y) * width * 4;
      for (int argb : row) {
        rgba[at++] = (byte) (argb >> 16);
        rgba[at++] = (byte) (argb >> 8);
        rgba[at++] = (byte) argb;
        rgba[at++] = (byte) (argb >> 24);
      }
    }
    // A palette of greys makes a greyscale image.
    boolean grey = image.getRaster().getNumDataElements() <= 2 && isGrey(rgba);
    int components = (grey ? 1 : 3) + (image.getColorModel().hasAlpha() ? 1 : 0);
    return new Texture.Image(width, height, components, rgba);
  }

  /**
   * Copies the grey samples of the file unchanged, since ImageIO treats them as linear and would
   * brighten them.
   */
  private static Texture.Image grey(Raster raster, int bits) {
    int width = raster.getWidth();
    int height = raster.getHeight();
    int bands = raster.getNumBands();
    byte[] rgba = new byte[width * height * 4];
    int[] row = new int[width * bands];
    int most = (1 << bits) - 1;
    for (int y = 0; y < height; y++) {
      raster.getPixels(0, y, width, 1, row);
      int at = (height - 1 - y) * width * 4;
      for (int x = 0; x < width; x++, at += 4) {
        byte value = byteOf(row[x * bands], most);
        rgba[at] = value;
        rgba[at + 1] = value;
        rgba[at + 2] = value;
        rgba[at + 3] = bands == 1 ? (byte) 255 : byteOf(row[x * bands + 1], most);
      }
    }
    return new Texture.Image(width, height, Math.min(2, bands), rgba);
  }

  private static byte byteOf(int sample, int most) {
    return (byte) ((sample * 255L + most / 2) / most);
  }

  static boolean isGrey(byte[] rgba) {
    for (int i = 0; i < rgba.length; i += 4) {
      if (rgba[i] != rgba[i + 1] || rgba[i] != rgba[i + 2]) {
        return false;
      }
    }
    return true;
  }

  /**
   * Decodes an SFImage: width, height, components, then a number per pixel from the lowest row up
   * (X3D 4.0, 5.3.6).
   *
   * @throws IOException if the number of pixels does not match the size
   */
  static Texture.Image pixels(int[] image) throws IOException {
    int width = image.length < 3 ? 0 : image[0];
    int height = image.length < 3 ? 0 : image[1];
    int components = image.length < 3 ? 0 : image[2];
    if (width < 1 || height < 1 || components < 1 || components > 4) {
      throw new IOException("contains no image: it needs width, height and 1 to 4 components");
    }
    return pixels(image, 3, width, height, 1, components);
  }

  /**
   * Decodes the pixels of a PixelTexture3D: components, width, height, depth, then a number per
   * pixel from the lowest row of the first slice on (X3D 4.0, 33.4.3).
   *
   * @throws IOException if the number of pixels does not match the size
   */
  static Texture.Image volume(int[] image) throws IOException {
    boolean whole = image.length >= 4;
    if (!whole || image[0] < 1 || image[0] > 4 || image[1] < 1 || image[2] < 1 || image[3] < 1) {
      throw new IOException(
          "contains no image: it needs 1 to 4 components, width, height and depth");
    }
    return pixels(image, 4, image[1], image[2], image[3], image[0]);
  }

  private static Texture.Image pixels(
      int[] image, int from, int width, int height, int layers, int components) throws IOException {
    double pixels = (double) width * height * layers;
    if (pixels > MAX_PIXELS || image.length - from < pixels) {
      throw new IOException(
          "announces %s x %s%s pixels but contains %s"
              .formatted(width, height, layers == 1 ? "" : " x " + layers, image.length - from));
    }
    byte[] rgba = new byte[(int) pixels * 4];
    for (int i = 0; i < pixels; i++) {
      int value = image[i + from];
      boolean colour = components > 2;
      boolean alpha = components == 2 || components == 4;
      int rgb = alpha ? value >>> 8 : value;
      rgba[4 * i] = (byte) (colour ? rgb >> 16 : rgb);
      rgba[4 * i + 1] = (byte) (colour ? rgb >> 8 : rgb);
      rgba[4 * i + 2] = (byte) rgb;
      rgba[4 * i + 3] = (byte) (alpha ? value : 255);
    }
    return new Texture.Image(width, height, layers, components, rgba);
  }
}
