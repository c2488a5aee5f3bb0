package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

/** Pictures: PNG, JPEG, GIF, BMP, TGA, DDS, KTX2, Radiance and what else a texture may be. */
public final class ImageFuzzTarget {
  private static final long BUDGET = 64L << 20;

  private ImageFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    UrlContent file = new UrlContent.OfBytes("fuzz", "fuzz", BaseUrl.folder(Path.of("")), input);
    try {
      ImageDecoder.read(file, new AtomicLong(BUDGET));
    } catch (IOException e) {
      // Not a picture, a damaged one, or one that is too large.
    }
  }
}
