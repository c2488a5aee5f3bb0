package org.selectiverenderer.runtime.movie;

import java.io.IOException;

/** A film as a file has it. Nobody changes it; any thread may read it. */
public interface Movie {
  /** Pixels. */
  int width();

  /** Pixels. */
  int height();

  /** Whether one can see through some of its pixels, now or then. */
  boolean translucent();

  /** How many pictures it has. */
  int pictures();

  /** How long it takes at its own speed. */
  double seconds();

  /**
   * Which picture is shown at a time.
   *
   * @param seconds from the beginning; before it the first one is meant, after the end the last
   */
  int at(double seconds);

  /**
   * What is wrong with it although it can be shown, as a clause that reads after the file's name;
   * may take as long as a picture takes to decode.
   *
   * @return empty for nothing
   */
  default String flaw() {
    return "";
  }

  /** Begins to decode it. */
  Pictures open();

  /** Makes pictures. Belongs to one thread at a time; of one after the other it makes the best. */
  interface Pictures {
    /**
     * Makes one.
     *
     * @param picture 0 to {@link Movie#pictures()} without it
     * @return four bytes r, g, b, a per pixel, which nobody changes; the first row is the lowest
     * @throws IOException with a clause that reads after the file's name, when it is damaged
     */
    byte[] picture(int picture) throws IOException;
  }
}
