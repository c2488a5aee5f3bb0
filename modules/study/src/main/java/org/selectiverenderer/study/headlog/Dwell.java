package org.selectiverenderer.study.headlog;

/**
 * A dwell: a period in which one object was in the middle of the view, or under the gaze.
 *
 * @param start seconds since the session began
 * @param end seconds since the session began
 * @param version the version shown at the start (whichChoice of its Switch); -1 for an object
 *     without versions
 */
record Dwell(String object, double start, double end, int version) {
  /** Returns the duration in seconds. */
  public double duration() {
    return end - start;
  }
}
