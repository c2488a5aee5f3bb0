package org.selectiverenderer.browser.movie;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.browser.movie.mpeg.MpegVideo;
import org.selectiverenderer.x3d.url.UrlContent;

/** Reads movie files: MPEG-1 video and animated GIF. */
public final class MovieReader {
  /** Largest size of a file in bytes. */
  public static final int MAX_BYTES = 256 << 20;

  /** Largest number of pixels of a frame: that of 4096 x 2160. */
  static final long MAX_PIXELS = 4096L * 2160;

  private static final int BEGINNING = 16;

  private MovieReader() {}

  /**
   * Reads a file. Its frames are decoded later.
   *
   * @param budget the bytes left for all movies of a load; reduced by this one
   * @return the movie; empty if the file is no movie
   * @throws IOException with a clause as message that follows the file's name
   */
  public static Optional<Movie> read(UrlContent file, AtomicLong budget) throws IOException {
    byte[] beginning;
    try (InputStream in = file.open()) {
      beginning = in.readNBytes(BEGINNING);
    }
    boolean gif = GifReader.is(beginning);
    if (!gif && !MpegVideo.is(beginning)) {
      return Optional.empty();
    }
    byte[] bytes = file.bytes(MAX_BYTES);
    // The video extracted from a system stream is kept in addition to the file.
    if (budget.addAndGet(-2L * bytes.length) < 0) {
      budget.addAndGet(2L * bytes.length);
      throw new IOException(
          "has %s bytes, for which there is not enough memory".formatted(bytes.length));
    }
    if (gif) {
      return GifReader.read(bytes);
    }
    MpegVideo video = MpegVideo.of(bytes);
    check(video.width(), video.height());
    return Optional.of(new MpegMovie(video));
  }

  static void check(int width, int height) throws IOException {
    if (width < 1 || height < 1 || (long) width * height > MAX_PIXELS) {
      throw new IOException(
          "has pictures of %s x %s pixels; the limit is %s pixels"
              .formatted(width, height, MAX_PIXELS));
    }
  }
}
