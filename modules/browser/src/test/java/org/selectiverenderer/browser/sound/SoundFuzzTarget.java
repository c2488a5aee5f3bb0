package org.selectiverenderer.browser.sound;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

/** Sounds: WAV, AIFF and AU. */
public final class SoundFuzzTarget {
  private static final long BUDGET = 64L << 20;

  private SoundFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    UrlContent file = new UrlContent.OfBytes("fuzz", "fuzz", BaseUrl.folder(Path.of("")), input);
    try {
      SoundFileReader.read(file, new AtomicLong(BUDGET));
    } catch (IOException e) {
      // Damaged, or too large.
    }
  }
}
