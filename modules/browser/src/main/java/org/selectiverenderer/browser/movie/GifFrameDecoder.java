package org.selectiverenderer.browser.movie;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.jspecify.annotations.Nullable;

/** Decodes the frames of an animated GIF and composes each over those before it. */
final class GifFrameDecoder implements Movie.Pictures {
  private final GifMovie movie;

  /** The composed image, one ARGB number per pixel, from the top left corner. */
  private int[] canvas = new int[0];

  private int[] saved = new int[0];
  private @Nullable ImageReader reader;
  private GifMovie.@Nullable Part last;
  private int lastWidth;
  private int lastHeight;

  /** The index of the next frame to be drawn. */
  private int next;

  GifFrameDecoder(GifMovie movie) {
    this.movie = movie;
  }

  @Override
  public byte[] picture(int picture) throws IOException {
    try {
      if (reader == null || next > picture) {
        rewind();
      }
      while (next <= picture) {
        dispose();
        draw(reader, next++);
      }
    } catch (IOException | RuntimeException e) { // ImageIO throws various exceptions.
      throw new IOException("is a damaged GIF from picture %s on".formatted(next + 1), e);
    }
    return rgba();
  }

  private void rewind() {
    if (reader != null) {
      reader.dispose();
    }
    reader = GifReader.reader();
    reader.setInput(
        new MemoryCacheImageInputStream(new ByteArrayInputStream(movie.file())), true, false);
    canvas = new int[movie.width() * movie.height()];
    last = null;
    next = 0;
  }

  /** Applies the disposal method of the last frame. */
  private void dispose() {
    if (last != null && last.disposal() == GifMovie.Disposal.CLEARED) {
      for (int y = last.top(); y < Math.min(movie.height(), last.top() + lastHeight); y++) {
        int row = y * movie.width();
        int right = Math.min(movie.width(), last.left() + lastWidth);
        Arrays.fill(canvas, row + Math.min(last.left(), right), row + right, 0);
      }
    } else if (last != null && last.disposal() == GifMovie.Disposal.AS_BEFORE) {
      canvas = saved;
    }
  }

  private void draw(ImageReader from, int index) throws IOException {
    GifMovie.Part part = movie.parts().get(index);
    if (part.disposal() == GifMovie.Disposal.AS_BEFORE) {
      saved = canvas.clone();
    }
    BufferedImage image = from.read(index);
    last = part;
    lastWidth = image.getWidth();
    lastHeight = image.getHeight();
    int across = Math.min(lastWidth, movie.width() - part.left());
    int[] row = new int[lastWidth];
    for (int y = 0; y < Math.min(lastHeight, movie.height() - part.top()); y++) {
      image.getRGB(0, y, lastWidth, 1, row, 0, lastWidth);
      int at = (part.top() + y) * movie.width() + part.left();
      for (int x = 0; x < across; x++) {
        if (row[x] >>> 24 != 0) {
          canvas[at + x] = row[x];
        }
      }
    }
  }

  private byte[] rgba() {
    byte[] rgba = new byte[4 * canvas.length];
    int width = movie.width();
    int to = 0;
    for (int y = movie.height() - 1; y >= 0; y--) {
      for (int at = y * width; at < (y + 1) * width; at++) {
        rgba[to++] = (byte) (canvas[at] >> 16);
        rgba[to++] = (byte) (canvas[at] >> 8);
        rgba[to++] = (byte) canvas[at];
        rgba[to++] = (byte) (canvas[at] >> 24);
      }
    }
    return rgba;
  }
}
