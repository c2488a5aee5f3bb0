package org.selectiverenderer.runtime.sound;

import java.io.IOException;

/** Where samples go. */
public interface SoundLine {
  /** Frames per second that it takes. */
  float RATE = 44_100;

  /** Opens one. */
  @FunctionalInterface
  interface Opening {
    /**
     * Opens the line.
     *
     * @throws IOException with a clause, when there is none
     */
    SoundLine open() throws IOException;
  }

  /**
   * Takes samples: 16 bits, the lower byte first, left before right. Waits while it has enough.
   *
   * @param length bytes, whole frames
   * @return whether it has taken them: false when it is closed, or the device has gone
   */
  boolean write(byte[] samples, int length);

  /** Ends it, and a {@link #write} that waits. From any thread, and more than once. */
  void close();
}
