package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.formats.image.CompactPngEncoder;
import org.selectiverenderer.formats.image.CompactPngEncoder.Samples;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Converts image files of all formats that scenes may use into PNG, with the colours that the
 * program shows. Of an animated GIF it takes the first frame.
 */
public final class ImageTranscoder {
  /** The share of Java's memory for a decoded image; the encoder takes as much again. */
  private static final int SHARE = 4;

  private ImageTranscoder() {}

  /**
   * Returns the bytes of a PNG file of the same image, with 8 bits per sample.
   *
   * @throws IOException if the file cannot be converted, with a predicate that follows its name
   */
  public static byte[] png(UrlContent file) throws IOException {
    AtomicLong budget = new AtomicLong(Runtime.getRuntime().maxMemory() / SHARE);
    Texture.Image image = ImageDecoder.read(file, budget);
    if (image.layers() != 1) {
      throw new IOException("holds a cube map or a volume, where one image is needed");
    }
    Samples samples =
        switch (image.components()) {
          case 1 -> Samples.GREY;
          case 2 -> Samples.GREY_ALPHA;
          case 3 -> Samples.RGB;
          default -> Samples.RGBA;
        };
    return CompactPngEncoder.of(
        image.width(), image.height(), samples, new byte[0], pixels(image, samples));
  }

  /** Returns the samples with rows from the top. */
  private static byte[] pixels(Texture.Image image, Samples samples) {
    int count = samples.count();
    byte[] pixels = new byte[image.width() * image.height() * count];
    int to = 0;
    for (int row = image.height() - 1; row >= 0; row--) {
      for (int from = 4 * row * image.width(); from < 4 * (row + 1) * image.width(); from += 4) {
        for (int sample = 0; sample < count; sample++) {
          boolean alpha = sample == count - 1 && image.translucent();
          pixels[to++] = image.rgba()[from + (alpha ? 3 : sample)];
        }
      }
    }
    return pixels;
  }
}
