package org.selectiverenderer.runtime.movie;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.runtime.movie.mpeg.MpegVideo;
import org.selectiverenderer.x3d.files.Content;

/** Reads films: MPEG-1 and animated GIF. */
public final class MovieReader {
  /** Bytes of a file. */
  public static final int MAX_BYTES = 256 << 20;

  /** Pixels of a picture: those of 4096 x 2160. */
  static final long MAX_PIXELS = 4096L * 2160;

  private static final int BEGINNING = 16;

  private MovieReader() {}

  /**
   * Reads a file. Its pictures are decoded later.
   *
   * @param budget bytes left for all films of a load; those of this one are taken from it
   * @return empty when it is no film
   * @throws IOException with a clause that reads after the file's name
   */
  public static Optional<Movie> read(Content file, AtomicLong budget) throws IOException {
    byte[] beginning;
    try (InputStream in = file.open()) {
      beginning = in.readNBytes(BEGINNING);
    }
    boolean gif = GifReader.is(beginning);
    if (!gif && !MpegVideo.is(beginning)) {
      return Optional.empty();
    }
    byte[] bytes = file.bytes(MAX_BYTES);
    // The video of a stream is kept beside it.
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
