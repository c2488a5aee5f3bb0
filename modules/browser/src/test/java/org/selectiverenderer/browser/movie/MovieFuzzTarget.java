package org.selectiverenderer.browser.movie;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

/** Movies: MPEG-1 and animated GIF, with their first pictures. */
public final class MovieFuzzTarget {
  private static final long BUDGET = 64L << 20;
  private static final int PICTURES = 3;

  private MovieFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    UrlContent file = new UrlContent.OfBytes("fuzz", "fuzz", BaseUrl.folder(Path.of("")), input);
    try {
      Movie movie = MovieReader.read(file, new AtomicLong(BUDGET)).orElse(null);
      if (movie != null) {
        movie.at(1e9);
        Movie.Pictures pictures = movie.open();
        for (int i = 0; i < Math.min(PICTURES, movie.pictures()); i++) {
          pictures.picture(i);
        }
      }
    } catch (IOException e) {
      // Damaged, or too large.
    }
  }
}
