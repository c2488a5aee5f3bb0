package org.selectiverenderer.study.headlog;

/**
 * A dwell: a period in which one object was in the middle of the view, or under the gaze.
 *
 * @param start seconds since the session began
 * @param end seconds since the session began
 * @param version the version shown at the start (whichChoice of its Switch); -1 for an object
 *     without versions
 * @param seconds time on the object from start to end; short looks at others in between left out
 */
public record Dwell(String object, double start, double end, int version, double seconds) {
  /** Returns the duration in seconds, short gaps included. */
  public double duration() {
    return end - start;
  }

  /** Returns this dwell, continued to another end. */
  Dwell until(double later, double more) {
    return new Dwell(object, start, later, version, seconds + more);
  }
}
