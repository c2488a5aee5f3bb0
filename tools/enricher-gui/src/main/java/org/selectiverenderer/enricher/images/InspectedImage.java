package org.selectiverenderer.enricher.images;

import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * What the first readable url of an image leads to. A value.
 *
 * @param thumbnail a small picture; empty if it cannot be decoded
 * @param width in pixels; 0 if not known
 * @param height in pixels; 0 if not known
 * @param bytes size of the file; 0 if there is none
 * @param fault a clause that says what is wrong; empty if it can be read
 */
public record InspectedImage(
    Optional<BufferedImage> thumbnail, int width, int height, long bytes, String fault) {
  /** Larger files are not read. */
  private static final long MOST_BYTES = 128L << 20;

  /** Larger images are not decoded for a thumbnail. */
  private static final long MOST_PIXELS = 100_000_000;

  private static final int BYTES_PER_TEXEL = 4;

  /** Returns the bytes of the texture with its mipmaps on the graphics card. */
  public long cardBytes() {
    return (long) width * height * BYTES_PER_TEXEL * 4 / 3;
  }

  /** Returns whether there is no file to read. */
  public boolean missing() {
    return !readable() && bytes == 0;
  }

  /** Returns whether it can be read. */
  public boolean readable() {
    return fault.isEmpty();
  }

  /**
   * Reads an image. Blocks for files and, for hosts that are allowed, the network: not for the
   * event dispatch thread.
   *
   * @param urls the urls of the field, relative to the folder
   * @param side the longest side of the thumbnail in pixels
   */
  public static InspectedImage of(List<String> urls, UrlResolver resolver, Path folder, int side) {
    String first = "";
    for (String url : urls) {
      UrlResolver.Target target = resolver.resolve(url, folder);
      if (target instanceof UrlResolver.Target.Found found) {
        return of(found.content(), side);
      }
      if (first.isEmpty() && target instanceof UrlResolver.Target.Refused refused) {
        first = refused.reason();
      }
    }
    return failed(
        0, first.isEmpty() ? Texts.of("images.nourl") : Texts.of("images.missing", first));
  }

  private static InspectedImage failed(long bytes, String why) {
    return new InspectedImage(Optional.empty(), 0, 0, bytes, why);
  }

  private static InspectedImage of(UrlContent content, int side) {
    try {
      long size = content.size();
      if (size > MOST_BYTES) {
        return failed(size, Texts.of("images.large"));
      }
      byte[] bytes;
      try (InputStream in = content.open()) {
        bytes = in.readNBytes((int) MOST_BYTES);
      }
      return decoded(bytes, side);
    } catch (IOException e) {
      return failed(0, String.valueOf(e.getMessage()));
    }
  }

  private static InspectedImage decoded(byte[] bytes, int side) throws IOException {
    try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (!readers.hasNext()) {
        return failed(bytes.length, Texts.of("images.unknown"));
      }
      ImageReader reader = readers.next();
      try {
        reader.setInput(in, true, true);
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        Optional<BufferedImage> small =
            (long) width * height > MOST_PIXELS
                ? Optional.empty()
                : Optional.of(small(reader, Math.max(width, height), side));
        return new InspectedImage(small, width, height, bytes.length, "");
      } catch (RuntimeException e) { // as readers throw for damaged files
        return failed(bytes.length, Texts.of("images.damaged"));
      } finally {
        reader.dispose();
      }
    } catch (IOException e) {
      return failed(bytes.length, Texts.of("images.damaged"));
    }
  }

  private static BufferedImage small(ImageReader reader, int longest, int side) throws IOException {
    ImageReadParam every = reader.getDefaultReadParam();
    int step = Math.max(1, longest / (2 * side)); // then smoothly by two
    every.setSourceSubsampling(step, step, 0, 0);
    BufferedImage read = reader.read(0, every);
    double scale = Math.min(1, (double) side / Math.max(read.getWidth(), read.getHeight()));
    int width = Math.max(1, (int) Math.round(read.getWidth() * scale));
    int height = Math.max(1, (int) Math.round(read.getHeight() * scale));
    BufferedImage small = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    var graphics = small.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    graphics.drawImage(read, 0, 0, width, height, null);
    graphics.dispose();
    return small;
  }
}
