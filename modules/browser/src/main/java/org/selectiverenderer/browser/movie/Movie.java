package org.selectiverenderer.browser.movie;

import java.io.IOException;

/** A movie file with its frames' times. Immutable and thread-safe. */
public interface Movie {
  /** Returns the width in pixels. */
  int width();

  /** Returns the height in pixels. */
  int height();

  /** Returns whether any frame has transparent pixels. */
  boolean translucent();

  /** Returns the number of frames. */
  int pictures();

  /** Returns the duration in seconds at normal speed. */
  double seconds();

  /**
   * Returns the index of the frame shown at a time.
   *
   * @param seconds the time from the beginning; negative times give the first frame, times after
   *     the end the last
   */
  int at(double seconds);

  /**
   * Returns a defect that does not prevent playing, as a clause that follows the file's name. The
   * call may take as long as decoding a frame.
   *
   * @return the clause; empty for none
   */
  default String flaw() {
    return "";
  }

  /** Makes a decoder for the movie. */
  Pictures open();

  /** Decodes frames; fastest in ascending order. Belongs to one thread at a time. */
  interface Pictures {
    /**
     * Decodes a frame.
     *
     * @param picture the index of the frame, from 0 to below {@link Movie#pictures()}
     * @return four bytes r, g, b, a per pixel, not to be changed; the first row is the lowest
     * @throws IOException if the frame is damaged, with a clause as message that follows the file's
     *     name
     */
    byte[] picture(int picture) throws IOException;
  }
}
