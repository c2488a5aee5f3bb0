package org.selectiverenderer.browser.movie.mpeg;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.browser.sound.SoundFileReader;

/** Soundtracks of movies: MPEG system streams with MPEG audio. */
public final class SoundtrackFuzzTarget {
  private static final int BUDGET = 64 << 20;

  private SoundtrackFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    try {
      Optional<byte[]> audio = SoundtrackReader.read(new ByteArrayInputStream(input), BUDGET);
      if (audio.isPresent()) {
        SoundFileReader.mpegAudio(audio.get(), new AtomicLong(BUDGET));
      }
    } catch (IOException e) {
      // No sound, a damaged one, or one that is too large.
    }
  }
}
