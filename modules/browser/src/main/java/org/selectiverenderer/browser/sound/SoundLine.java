package org.selectiverenderer.browser.sound;

import java.io.IOException;

/** An output line for samples. */
public interface SoundLine {
  /** The sample rate of the line: frames per second. */
  float RATE = 44_100;

  /** Opens a line. */
  @FunctionalInterface
  interface Opening {
    /**
     * Opens the line.
     *
     * @throws IOException with a clause as message if there is none
     */
    SoundLine open() throws IOException;
  }

  /**
   * Writes samples: 16-bit little-endian stereo, left before right. Waits while the line's buffer
   * is full.
   *
   * @param length the number of bytes, in whole frames
   * @return whether the samples were written: false if the line is closed or the device was removed
   */
  boolean write(byte[] samples, int length);

  /**
   * Closes the line and ends a {@link #write} that waits. May be called from any thread, and more
   * than once.
   */
  void close();
}
